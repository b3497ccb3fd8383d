import type { ValuesNotice } from '../../../notation/index.ts';
import { fields } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { typeValues } from './typed-values.ts';

interface OtherReadingProps {
  readonly path: string;
  readonly notice: ValuesNotice;
}

/** How a number in a field of registers is read, and what else it may be at one click. */
export function OtherReading({ path, notice }: OtherReadingProps) {
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
