import { useState } from 'preact/hooks';
import { readNumber } from '../../../notation/index.ts';
import { filled, itemsOf, moved } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { fields } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { firstOf } from './first-of.ts';
import { usePages } from './pages.tsx';

/** Items shown at a time: enough to see, few enough to draw while typing. */
const PAGE = 16;

interface ListProps {
  readonly path: string;
}

/** The items of a list with their addresses: change, add, remove, move and fill them. */
export function ListItems({ path }: ListProps) {
  const words = useWords('oneByOne');
  const text = fields.at(path).text.value;
  const first = firstOf(path);
  const items = itemsOf(text);
  const put = (next: readonly string[], done = true) => (done ? fields.choose : fields.type)(path, next.join(' '));
  const { start, end, turning, show } = usePages(items.length, PAGE, words);
  return (
    <>
      <ol start={start + 1}>
        {items.slice(start, end).map((item, offset) => {
          const index = start + offset;
          const address = first === undefined ? undefined : first + index;
          return (
            <li key={index}>
              <span class="mono">{words.itemShort(index, address)}</span>
              <input
                class="mono"
                autocomplete="off"
                spellcheck={false}
                aria-label={words.item(index, address)}
                value={item}
                onInput={({ currentTarget }) => put(items.with(index, currentTarget.value.trim() || '0'), false)}
              />
              <button
                type="button"
                aria-label={words.up(index)}
                {...disabledFor(index === 0 ? words.atFirst : undefined)}
                onClick={() => put(moved(items, index, index - 1))}
              >
                ↑
              </button>
              <button
                type="button"
                aria-label={words.down(index)}
                {...disabledFor(index === items.length - 1 ? words.atLast : undefined)}
                onClick={() => put(moved(items, index, index + 1))}
              >
                ↓
              </button>
              <button type="button" aria-label={words.remove(index)} onClick={() => put(items.toSpliced(index, 1))}>
                ×
              </button>
            </li>
          );
        })}
      </ol>
      {turning}
      <button
        type="button"
        onClick={() => {
          put([...items, '0']);
          show(items.length);
        }}
      >
        {words.add}
      </button>
      <Fill count={items.length} onFill={put} />
    </>
  );
}

interface FillProps {
  /** How many items the list has. */
  readonly count: number;
  readonly onFill: (items: readonly string[]) => void;
}

/** Makes all items anew: how many, the first, and how much each is more than the one before it. */
function Fill({ count, onFill }: FillProps) {
  const words = useWords('oneByOne');
  const [typed, setTyped] = useState<Partial<Record<'count' | 'value' | 'step', string>>>({});
  const texts = { count: String(count), value: '0', step: '0', ...typed };
  const inputs = [
    ['count', words.fillCount],
    ['value', words.fillValue],
    ['step', words.fillStep],
  ] as const;
  const fill = () =>
    onFill(
      filled({
        count: readNumber(texts.count) ?? count,
        value: readNumber(texts.value) ?? 0,
        step: readNumber(texts.step) ?? 0,
      }),
    );
  return (
    <fieldset class="fill">
      <legend>{words.fill}</legend>
      {inputs.map(([name, label]) => (
        <label key={name}>
          {label}
          <input
            class="mono"
            autocomplete="off"
            value={texts[name]}
            onInput={({ currentTarget }) => setTyped({ ...typed, [name]: currentTarget.value })}
          />
        </label>
      ))}
      <button type="button" onClick={fill}>
        {words.fill}
      </button>
    </fieldset>
  );
}
