import { useEffect } from 'preact/hooks';
import { firstFrame, identityOf, inputMeaning, readText } from '../../workbench/index.ts';
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
        meaningOf: (reading, draft) => inputMeaning(reading, { draft }),
        start: (take, ended) => startWorker('reader', take, (why) => ended(why === 'died')),
      }),
    [],
  );
  return null;
}
