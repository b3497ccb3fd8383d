import { compareFrames } from '../../diagnosis/index.ts';
import type { Compared, CompareProps } from './compared.ts';
import { CauseLine, DifferenceList } from './difference-list.tsx';
import { compareWords as words } from './language.ts';
import { comparing, readSent, sentText } from './sent.ts';
import { SideBySide } from './side-by-side.tsx';

/** The frame at hand beside what a device sent: what differs, why, and what to do. */
export function ComparePanel({ draft, frame }: CompareProps) {
  const text = sentText.value;
  const theirs = readSent(text);
  const wrong = theirs === undefined;
  return (
    <details
      class="panel compare"
      open={comparing.value}
      onToggle={({ currentTarget }) => {
        comparing.value = currentTarget.open;
      }}
    >
      <summary>
        <h2>{words.title}</h2>
      </summary>
      <div class="control" data-invalid={wrong ? '' : undefined}>
        <label for="sent">{words.sent}</label>
        <textarea
          id="sent"
          class="mono"
          rows={Math.min(12, Math.max(2, Math.ceil(text.length / 64), text.split('\n').length))}
          autocomplete="off"
          spellcheck={false}
          autocapitalize="off"
          value={text}
          aria-invalid={wrong}
          aria-describedby="sent-said"
          onInput={({ currentTarget }) => {
            sentText.value = currentTarget.value;
          }}
        />
        <p class="said" id="sent-said" aria-live="polite">
          {wrong ? <span class="error">{words.notBytes}</span> : words.sentHint}
        </p>
      </div>
      {comparing.value && theirs !== undefined && theirs.length > 0 && (
        <Result draft={draft} frame={frame} theirs={theirs} />
      )}
    </details>
  );
}

function Result({ draft, frame, theirs }: CompareProps & { readonly theirs: Uint8Array }) {
  if (frame === undefined) return <p>{words.noFrame}</p>;
  const { bytes: mine, reading } = frame;
  const { transport, direction } = reading;
  const comparison = compareFrames(mine, theirs, { transport, direction, request: readSent(draft.answering) });
  const { causes, differences } = comparison;
  const identical = causes.some(({ code }) => code === 'identical');
  const compared: Compared = { comparison, mine, theirs, ascii: transport === 'ascii' };
  return (
    <>
      <p class="verdict" data-severity={identical ? undefined : 'error'} aria-live="polite">
        <strong>{identical ? words.identical : words.differences(differences.length)}</strong>
      </p>
      {causes.map((cause) => (
        <CauseLine key={cause.code} cause={cause} />
      ))}
      <SideBySide {...compared} />
      {differences.length > 0 && <DifferenceList {...compared} />}
    </>
  );
}
