import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { How } from '../../../workbench/index.ts';
import { page } from '../../parts/store.ts';

/** Typing is read at a pause of this many milliseconds. */
const PAUSE = 150;

/** The text of the input while it is typed in. */
export function useTyping() {
  const [typed, setTyped] = useState<string>();
  const waiting = useRef<{ readonly text: string; readonly timer: ReturnType<typeof setTimeout> }>(undefined);
  const stop = () => {
    clearTimeout(waiting.current?.timer);
    waiting.current = undefined;
    setTyped(undefined);
  };
  const { value: given } = page.input;
  // What comes from elsewhere, such as an example, takes the place of what is being typed.
  // Before it is painted: what somebody types then would be given up with it.
  useLayoutEffect(stop, [given]);
  /** Reads what was typed and not read yet. */
  const read = (how: How) => {
    const text = waiting.current?.text;
    stop();
    if (text !== undefined) page.takeInput(text, how);
  };
  return {
    text: typed ?? given,
    read,
    /** Takes a changed text: at a pause, or at once as a step. */
    type: (text: string, how: How) => {
      clearTimeout(waiting.current?.timer);
      waiting.current = { text, timer: setTimeout(() => read('edit'), PAUSE) };
      setTyped(text);
      if (how === 'step') read('step');
    },
  };
}
