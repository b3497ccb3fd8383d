import { useEffect, useRef } from 'preact/hooks';
import { diagnose, type Finding, findingKinds } from '../../../diagnosis/index.ts';
import type { Reading } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { addressOf, repair } from '../../../store/index.ts';
import { type Draft, itemContext, primaryRepair, requestOf } from '../../../workbench/index.ts';
import { useNaming } from '../device/naming.ts';
import { pasted } from '../pasted.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import { found } from './found.ts';
import './findings.css';

/** Milliseconds after the last change at which a frame is looked into. */
const PAUSE = 120;
/** Repairs offered of one finding. */
const REPAIRS = 3;

interface FindingsProps {
  readonly draft: Draft;
  readonly bytes: Uint8Array;
  readonly reading: Reading;
}

/** Looks into the current frame, and tells the strip what it found. It shows nothing itself. */
export function Finder({ draft, bytes, reading }: FindingsProps) {
  const say = useWords('findings');
  const first = useRef(true);
  useEffect(() => {
    const { transport } = draft;
    const look = () => {
      const item = pasted.itemWith(bytes);
      const context = item && itemContext(item, transport);
      const findings = diagnose(bytes, { transport, request: requestOf(draft), ...context });
      const [best] = findings;
      const { title, cause = `${title}.` } = best ? say(best) : { title: '' };
      found.value = {
        of: bytes,
        findings,
        cause: best ? cause : '',
        sound: best === undefined || (findingKinds[best.code] === 'sound' && best.code !== 'valid-exception'),
        repair: primaryRepair({ bytes, reading }, findings),
        use: (repaired) => repair(page, draft, repaired),
      };
    };
    const pause = setTimeout(look, first.current ? 0 : PAUSE);
    first.current = false;
    return () => clearTimeout(pause);
  }, [bytes]);
  return null;
}

/** Why the current frame fails, in plain words, the most useful first; of a frame that was pasted, also that it does not. */
export function Findings({ draft, bytes, reading }: FindingsProps) {
  const names = useNaming()?.(reading);
  const { value } = found;
  // What was found of other bytes is out of date.
  if (value?.of !== bytes) return null;
  const departures = reading.problems.map((problem) => names?.departure(problem)).filter(Boolean);
  return (
    <div class="findings">
      {departures.map((line) => (
        <p key={line}>{line}</p>
      ))}
      <ol>
        {value.findings.map((finding) => (
          <Item key={finding.code} finding={finding} draft={draft} />
        ))}
      </ol>
    </div>
  );
}

function Item({ finding, draft }: { finding: Finding; draft: Draft }) {
  const words = useWords('read');
  const { title, why, todo } = useWords('findings')(finding);
  const { code, from, to, repaired, confidence } = finding;
  const kind = findingKinds[code];
  const tone = kind === 'sound' ? undefined : confidence === 'certain' ? 'error' : 'warning';
  return (
    <li data-severity={tone} data-from={from} data-to={to}>
      <h3>
        {title} {(kind === 'cause' || kind === 'crc-cause') && <small>{words.confidences[confidence]}</small>}
      </h3>
      <p>{why}</p>
      {todo && <p>{todo}</p>}
      {kind === 'sound' && draft.kind === 'request' && (
        <p>
          <a href={addressOf('bus', { tab: 'no-answer' })}>{words.noAnswer}</a>
        </p>
      )}
      {repaired.length > 0 && (
        <p class="in-row">
          {repaired.slice(0, REPAIRS).map((bytes) => (
            <button key={formatBytes(bytes)} type="button" onClick={() => repair(page, draft, bytes)}>
              {words.useRepaired} <span class="mono">{formatBytes(bytes)}</span>
            </button>
          ))}
        </p>
      )}
    </li>
  );
}
