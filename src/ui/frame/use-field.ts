import type { Field } from '../../modbus/index.ts';
import { formatHex, readNumber, zeroBasedAddress } from '../../notation/index.ts';
import type { Words } from '../../words/index.ts';
import { rangeOf } from '../../workbench/index.ts';
import { idOf } from '../parts/labelled.tsx';
import { fields } from '../parts/store.ts';
import { useWords } from '../parts/words.ts';

/** What the field at a path shows: `labelled` is for its `Labelled`, `input` for the input in it. */
export function useField(path: string) {
  const { labels } = useWords('page');
  const { field, text, error, section, span, problems } = fields.at(path);
  const name = field.value?.name ?? path;
  return {
    text: text.value,
    labelled: {
      path,
      label: labels[name] ?? name,
      error: error.value,
      section: section.value,
      span: span.value,
      problems: problems.value,
    },
    input: {
      id: idOf(path),
      text: text.value,
      wrong: error.value !== undefined,
      onText: (typed: string) => fields.type(path, typed),
    },
  };
}

/** A number in the notations that are not typed, and its legal range; `undefined` if the text is not a whole number, or rounded. */
export function numberHint(field: Field, text: string, words: Words): string | undefined {
  const value = field.kind === 'address' ? zeroBasedAddress(text) : readNumber(text);
  const { least, most } = rangeOf(field);
  if (value === undefined || !Number.isSafeInteger(value) || value < 0) return undefined;
  const legal = field.range ? words.page.legal(least, most) : undefined;
  return [String(value), formatHex(value, 2 * field.width), legal].filter((part) => part !== undefined).join(', ');
}
