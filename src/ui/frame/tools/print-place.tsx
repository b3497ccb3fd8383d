import { useEffect, useState } from 'preact/hooks';
import { useCommand, useKeyOf } from '../../parts/commands.ts';
import { part, Slot, useCode } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';

const sheet = part(
  ['wire', 'tools', 'complaints'],
  () => import('../../parts/frame-tabs/wire/print-sheet.tsx'),
  ({ PrintSheet }) => PrintSheet,
);

/** Signs that somebody is there. */
const TOUCHES = ['pointermove', 'pointerdown', 'keydown', 'scroll'];

/**
 * Prints a sheet of the frame. Browsers do not wait for what a page loads when it is printed by their own menu: the sheet is
 * loaded once somebody is there and the page has nothing else to do.
 */
export function PrintPlace() {
  const { print: name, printAgain } = useWords('page').views;
  const [touched, setTouched] = useState(false);
  // How often printing was asked for here; −1 while the browser's own menu prints.
  const [asked, setAsked] = useState(0);
  const ready = useCode(sheet, touched);
  const ask = () => setAsked(Math.abs(asked) + 1);
  useCommand('print', ask);
  useEffect(() => {
    const watch = new AbortController();
    const { signal } = watch;
    const touch = () => (window.requestIdleCallback ?? setTimeout)(() => setTouched(true));
    for (const sign of TOUCHES) addEventListener(sign, touch, { signal, once: true });
    addEventListener('beforeprint', () => setAsked((before) => before || -1), { signal });
    addEventListener('afterprint', () => setAsked(0), { signal });
    return () => watch.abort();
  }, []);
  return (
    <>
      <p class="print-place">
        <button type="button" onClick={ask} {...useKeyOf('print')}>
          {name}
        </button>
      </p>
      {asked < 0 && !ready && <p>{printAgain}</p>}
      {asked !== 0 && <Slot part={sheet} with={{ asked }} />}
    </>
  );
}
