import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { ValuesNotice } from '../../notation/index.ts';
import { roomOf, typedAt } from '../../workbench/index.ts';
import { device } from '../parts/device/naming.ts';
import { useCode } from '../parts/slot.tsx';
import { useSteady } from '../parts/steady.ts';
import { draft, evaluation, fields } from '../parts/store.ts';
import { useVocabulary } from '../parts/words.ts';

const reader = { words: ['values'], load: () => import('./values/typed-values.ts') } as const;

/** How a field that may hold registers differs from any other; `input` is for its input. */
interface TypedValues {
  /** Whether the field holds registers. */
  readonly takes: boolean;
  readonly input: { readonly text?: string; readonly onText?: (text: string) => void; readonly onEnter?: () => void };
  /** What the values come to. */
  readonly hint?: string | undefined;
  /** A unit that was typed, of which nothing here says what it is in registers. */
  readonly unit?: string | undefined;
  /** Why what was typed is not a value. */
  readonly wrong?: string | undefined;
  /** A number that may be read in another way. */
  readonly other?: ValuesNotice | undefined;
}

/**
 * Lets values of any type and unit be typed into a field of registers. What reads them comes when the field has the focus,
 * when a device is chosen, or if the field does not hold plain numbers.
 */
export function useTypedValues(path: string, isWrong: boolean): TypedValues {
  const vocabulary = useVocabulary();
  const [entered, setEntered] = useState(false);
  const typedBefore = useRef<string | undefined>(undefined);
  const control = fields.at(path).control.value;
  const takes = useSteady(() => control !== undefined && roomOf(control, evaluation.value) > 0, [control]).value;
  const isTyped = useSteady(() => typedAt(draft.value, path) !== undefined, [path]).value;
  const come = useCode(reader, takes && (entered || isWrong || isTyped || device.value !== undefined));
  const values = useSteady(
    () => (come && control && takes ? come.typedValues(control, vocabulary.of('values')) : undefined),
    [come, control, takes],
  ).value;
  // What was typed before there was anything to read it is read now: at once, before anything else is typed.
  useLayoutEffect(() => {
    const typed = typedBefore.current;
    typedBefore.current = undefined;
    if (come && control && typed !== undefined && typed === control.text) come.typeValues(control, typed);
  }, [come]);
  if (come && control && values) {
    const { text, ...said } = values;
    return { takes, input: { text, onText: (typed) => come.typeValues(control, typed) }, ...said };
  }
  if (!takes) return { takes, input: {} };
  const onText = (typed: string) => {
    typedBefore.current = typed;
    fields.type(path, typed);
  };
  return { takes, input: { onText, onEnter: () => setEntered(true) } };
}
