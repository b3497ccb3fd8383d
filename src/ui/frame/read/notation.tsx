import type { TextReading } from '../../../workbench/index.ts';
import { pasted } from '../../parts/pasted.ts';
import { useWords } from '../../parts/words.ts';

/** What the text was read as, and what else it could be. */
export function Notation({ reading }: { reading: TextReading }) {
  const words = useWords('read');
  const { notation, alternatives, bytes, items, text } = reading;
  if (bytes.length === 0) return null;
  const frames = items.filter(({ kind }) => kind === 'frame').length;
  return (
    <div class="notation">
      <p>
        {words.readAs(notation)} {words.found(bytes.length, frames)}
      </p>
      {alternatives.map((other) => (
        <p key={other.reading} class="said">
          {words.otherwise(other.reading, other.bytes)}{' '}
          <button type="button" onClick={() => pasted.read(text, 'step', other.reading)}>
            {words.choose(other.reading)}
          </button>
        </p>
      ))}
    </div>
  );
}
