import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { useCommand, useKeyOf } from '../../parts/commands.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';

const sheet = part(
  ['wire', 'tools', 'complaints'],
  () => import('../../parts/frame-tabs/wire/print-sheet.tsx'),
  ({ PrintSheet }) => PrintSheet,
);

/** Prints a sheet of the frame. The sheet is loaded when it is asked for; the browser's own menu prints it from then on. */
export function PrintPlace() {
  const { print: name } = useWords('page').views;
  const asked = useSignal(0);
  const loaded = useSignal(false);
  const ask = () => {
    loaded.value = true;
    asked.value += 1;
  };
  useCommand('print', ask);
  useEffect(() => {
    const watch = new AbortController();
    const load = () => {
      loaded.value = true;
    };
    addEventListener('beforeprint', load, { signal: watch.signal });
    return () => watch.abort();
  }, []);
  return (
    <>
      <p class="print-place">
        <button type="button" onClick={ask} {...useKeyOf('print')}>
          {name}
        </button>
      </p>
      {loaded.value && <Slot part={sheet} with={{ asked: asked.value }} />}
    </>
  );
}
