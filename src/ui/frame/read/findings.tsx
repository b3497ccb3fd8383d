import { useEffect, useRef, useState } from 'preact/hooks';
import { diagnose, type Finding, findingKinds, identify } from '../../../diagnosis/index.ts';
import type { Reading } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { type Draft, requestOf } from '../../../workbench/index.ts';
import { useNaming } from '../../parts/device/naming.ts';
import { pasted } from '../../parts/pasted.ts';
import { page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import './read.css';

/** Milliseconds after the last change at which a frame is looked into. */
const PAUSE = 120;
/** Repairs offered of one finding. */
const REPAIRS = 3;

interface FindingsProps {
  readonly draft: Draft;
  readonly bytes: Uint8Array;
  readonly reading: Reading;
}

/** Why the current frame fails, in plain words, the most useful first; of a frame that was pasted, also that it does not. */
export function Findings({ draft, bytes, reading }: FindingsProps) {
  const words = useWords('read');
  const names = useNaming()?.(reading);
  const [found, setFound] = useState<{ readonly of: Uint8Array; readonly findings: readonly Finding[] }>();
  const first = useRef(true);
  useEffect(() => {
    const { transport } = draft;
    const look = () => {
      const context = pasted.contextOf(bytes, transport);
      setFound({ of: bytes, findings: diagnose(bytes, { transport, request: requestOf(draft), ...context }) });
    };
    const pause = setTimeout(look, first.current ? 0 : PAUSE);
    first.current = false;
    return () => clearTimeout(pause);
  }, [bytes]);
  // What was found of other bytes is out of date.
  if (found?.of !== bytes || found.findings.length === 0) return null;
  const departures = reading.problems.map((problem) => names?.departure(problem)).filter(Boolean);
  const [best] = found.findings;
  const sound = best !== undefined && findingKinds[best.code] === 'sound';
  return (
    <section class="panel findings" aria-labelledby="findings" aria-live="polite">
      <h2 id="findings">{sound ? words.nothingWrong : words.why}</h2>
      {departures.map((line) => (
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

function Item({ finding, draft }: { finding: Finding; draft: Draft }) {
  const words = useWords('read');
  const { title, why, todo } = useWords('findings')(finding);
  const { code, from, to, repaired, confidence } = finding;
  const kind = findingKinds[code];
  const tone = kind === 'sound' ? undefined : confidence === 'certain' ? 'error' : 'warning';
  const useFrame = (bytes: Uint8Array) => {
    const { transport } = draft;
    const request = requestOf(draft);
    const direction = draft.kind === 'request' ? 'request' : 'response';
    const [best] = identify(bytes, { transport, direction, request });
    if (best) page.showReading(best.reading, request, 'step');
  };
  return (
    <li data-severity={tone} data-from={from} data-to={to}>
      <h3>
        {title} {(kind === 'cause' || kind === 'crc-cause') && <small>{words.confidences[confidence]}</small>}
      </h3>
      <p>{why}</p>
      {todo && <p>{todo}</p>}
      <p class="in-row">
        {tone && to > from && (
          <button type="button" onClick={() => reveal(from)}>
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
function reveal(from: number): void {
  document.querySelector(`.strip [data-from="${from}"]`)?.scrollIntoView({ block: 'center' });
}
