import { useEffect } from 'preact/hooks';
import { firstFrame, identityOf, readText } from '../../workbench/index.ts';
import { pasted } from './pasted.ts';
import { startWorker } from './workers/start-worker.ts';

/** Reads the text that waits, and every other from then on. Shows nothing. */
export function Reader() {
  useEffect(
    () =>
      pasted.bring({
        readText,
        firstFrame,
        identityOf,
        start: (take, ended) => startWorker('reader', take, (why) => ended(why === 'died')),
      }),
    [],
  );
  return null;
}
