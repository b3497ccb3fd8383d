import { placeOf, readTyped, type TypedReading, unitsAt, withText } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { saidId } from '../../kit/field.tsx';
import { TextArea } from '../../kit/text-input.tsx';
import { draft, evaluation, fields, step } from '../../parts/store.ts';
import { valueStore } from '../../parts/value-store.ts';
import { useWords } from '../../parts/words.ts';
import { registersLine } from './typed-values.ts';

/** Most faults shown, and registers whose units are named. */
const SHOWN = 16;

/** Values as typed, one a line, what they come to, and what puts them into the field. */
export function TypedBox({ path }: { readonly path: string }) {
  const words = useWords('values');
  const target = fields.at(path).control.value;
  if (target === undefined) return null;
  const text = valueStore.typed.value;
  const source = valueStore.units.value;
  const read = readTyped(text, { control: target, draft: draft.value, evaluation: evaluation.value }, source);
  const wrong = read.faults.length > 0 || read.tooMany;
  const place = placeOf(target, draft.value, evaluation.value);
  const units = Array.from({ length: SHOWN }, (_, behind) =>
    unitsAt(source, place, behind).map(({ unit }) => unit),
  ).flat();
  return (
    <div class="control" data-invalid={wrong ? '' : undefined}>
      <label for="typed-values">{words.typed}</label>
      <TextArea
        id="typed-values"
        text={text}
        wrong={wrong}
        onText={(typed) => {
          valueStore.typed.value = typed;
        }}
      />
      <div class="said" id={saidId('typed-values')} aria-live="polite">
        <p>
          {words.typedHint} {units.length > 0 && words.unitsKnown([...new Set(units)])}
        </p>
        <Outcome text={text} read={read} />
      </div>
      <button
        type="button"
        {...disabledFor(read.text === undefined ? words.typedHint : undefined)}
        onClick={() => read.text !== undefined && step(withText(draft.value, target.path, read.text))}
      >
        {words.apply}
      </button>
    </div>
  );
}

/** What the typed values come to, line by line, or what is wrong with them. */
function Outcome({ text, read }: { readonly text: string; readonly read: TypedReading }) {
  const words = useWords('values');
  const { values, faults, notices, registers, tooMany } = read;
  const lineOf = (place: number) => words.line(text.slice(0, place).split('\n').length);
  return (
    <>
      {faults.slice(0, SHOWN).map(({ place, fault }) => (
        <p class="error" key={place.start}>
          {lineOf(place.start)} {words.fault(fault)}
        </p>
      ))}
      {tooMany && <p class="error">{words.onlyOne(registers.length)}</p>}
      {values.slice(0, SHOWN).flatMap(({ place, notes }) =>
        notes.map((note) => {
          const exact = note.code === 'in-units' && note.inUnits.exact;
          return (
            <p
              key={`${place.start}-${note.code}`}
              class={exact ? undefined : 'problem'}
              data-severity={exact ? undefined : 'warning'}
            >
              {lineOf(place.start)} {words.note(note)}
            </p>
          );
        }),
      )}
      {notices.map((notice) => (
        <div class="problem" data-severity="note" key={notice.place.start}>
          <p>
            {lineOf(notice.place.start)} {words.otherReading(notice)}
          </p>
          {[notice.list, notice.whole]
            .filter((other) => other !== undefined)
            .map((other) => (
              <button
                key={other}
                type="button"
                onClick={() => {
                  valueStore.typed.value = other;
                }}
              >
                {words.readAs(other)}
              </button>
            ))}
        </div>
      ))}
      {registers.length > 0 && faults.length === 0 && <p>{registersLine(registers, words)}</p>}
    </>
  );
}
