import { Component } from 'preact';
import { diagnose, type Finding, findingKinds, identify } from '../../../diagnosis/index.ts';
import type { Reading } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { type FindingWords, loadFindingWords } from '../../../words/index.ts';
import type { Draft } from '../../../workbench/index.ts';
import { requestOf } from '../../../workbench/index.ts';
import { naming } from '../../parts/device/naming.ts';
import { showReading } from '../../parts/pasted.ts';
import { fromText } from './asked.ts';
import { readWords as words } from './read-words.ts';

/** Milliseconds after the last change at which a frame is looked into. */
const PAUSE = 120;
/** Repairs offered of one finding. */
const REPAIRS = 3;

let findingWords: (finding: Finding) => FindingWords;

/** The findings with their words. */
export async function load(): Promise<typeof Findings> {
  findingWords = await loadFindingWords();
  return Findings;
}

export interface FindingsProps {
  readonly draft: Draft;
  readonly frame: { readonly bytes: Uint8Array; readonly reading: Reading } | undefined;
}

interface Found {
  readonly of: Uint8Array;
  readonly findings: readonly Finding[];
}

/** Why the current frame fails, in plain words, the most useful first; of a frame that was pasted, also that it does not. */
class Findings extends Component<FindingsProps, { found: Found | undefined }> {
  private pause: ReturnType<typeof setTimeout> | undefined;

  override componentDidMount() {
    this.ask(0);
  }

  override componentDidUpdate(before: FindingsProps) {
    if (before.frame?.bytes !== this.props.frame?.bytes) this.ask(PAUSE);
  }

  override componentWillUnmount() {
    clearTimeout(this.pause);
  }

  private ask(pause: number): void {
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      const { draft, frame } = this.props;
      if (frame === undefined) return;
      const { transport } = draft;
      const findings = diagnose(frame.bytes, {
        transport,
        request: requestOf(draft),
        ...fromText(frame.bytes, transport),
      });
      this.setState({ found: { of: frame.bytes, findings } });
    }, pause);
  }

  render() {
    const { draft, frame } = this.props;
    const { found } = this.state;
    // What was found of other bytes is out of date.
    if (frame === undefined || found?.of !== frame.bytes || found.findings.length === 0) return null;
    const names = naming.value?.(frame.reading);
    const said = frame.reading.problems.map((problem) => names?.departure(problem)).filter(Boolean);
    const [first] = found.findings;
    const sound = first !== undefined && findingKinds[first.code] === 'sound';
    return (
      <section class="panel findings" aria-labelledby="findings" aria-live="polite">
        <h2 id="findings">{sound ? words.nothingWrong : words.why}</h2>
        {said.map((line) => (
          <p key={line}>{line}</p>
        ))}
        <ol>
          {found.findings.map((finding) => (
            <Item key={finding.code} finding={finding} draft={draft} />
          ))}
        </ol>
      </section>
    );
  }
}

function Item({ finding, draft }: { finding: Finding; draft: Draft }) {
  const { title, why, todo } = findingWords(finding);
  const { code, from, to, repaired, confidence } = finding;
  const kind = findingKinds[code];
  const tone = kind === 'sound' ? undefined : confidence === 'certain' ? 'error' : 'warning';
  const useFrame = (bytes: Uint8Array) => {
    const { transport } = draft;
    const request = requestOf(draft);
    const direction = draft.kind === 'request' ? 'request' : 'response';
    const [best] = identify(bytes, { transport, direction, request });
    if (best) showReading(best, request, 'step');
  };
  return (
    <li data-severity={tone} data-from={from} data-to={to}>
      <h3>
        {title} {(kind === 'cause' || kind === 'crc-cause') && <small>{words.confidences[confidence]}</small>}
      </h3>
      <p>{why}</p>
      {todo && <p>{todo}</p>}
      <p class="finding-actions">
        {tone && to > from && (
          <button type="button" onClick={() => show(from)}>
            {words.showMe}
          </button>
        )}
        {repaired.slice(0, REPAIRS).map((bytes) => (
          <button key={formatBytes(bytes)} type="button" onClick={() => useFrame(bytes)}>
            {words.useRepaired} <span class="mono">{formatBytes(bytes)}</span>
          </button>
        ))}
      </p>
    </li>
  );
}

/** The bytes are lit while the button has the focus; this brings them into view. */
function show(from: number): void {
  document.querySelector(`.strip [data-from="${from}"]`)?.scrollIntoView({ block: 'center' });
}
