import type { ValuesNotice } from '../../../notation/index.ts';
import { fields } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { typeValues } from './typed-values.ts';
import { UnitHelp } from './unit-help.tsx';

interface DoubtsProps {
  readonly path: string;
  readonly unit: string | undefined;
  readonly other: ValuesNotice | undefined;
}

/** What is in doubt of a value in a field: its unit, which nothing here knows, or how its number is read. */
export const Doubts = ({ path, unit, other }: DoubtsProps) => (
  <>
    {unit !== undefined && <UnitHelp path={path} unit={unit} />}
    {other && <OtherReading path={path} notice={other} />}
  </>
);

interface OtherReadingProps {
  readonly path: string;
  readonly notice: ValuesNotice;
}

/** How a number in a field of registers is read, and what else it may be at one click. */
function OtherReading({ path, notice }: OtherReadingProps) {
  const words = useWords('values');
  const others = [notice.list, notice.whole].filter((typed) => typed !== undefined);
  const take = (typed: string) => {
    const control = fields.at(path).control.peek();
    if (control) typeValues(control, typed);
    fields.take();
  };
  return (
    <div class="problem" data-severity="note">
      <p>{words.otherReading(notice)}</p>
      {others.map((typed) => (
        <button key={typed} type="button" onClick={() => take(typed)}>
          {words.readAs(typed)}
        </button>
      ))}
    </div>
  );
}
