import { useEffect } from 'preact/hooks';
import { builtInProfiles } from '../../devices/index.ts';
import { type Draft, firstFrame, identityOf, inputMeaning, readText, type TextReading } from '../../workbench/index.ts';
import { allDevices } from './device/chosen.ts';
import { pasted } from './pasted.ts';
import { page } from './store.ts';
import { valueStore } from './value-store.ts';
import { startWorker } from './workers/start-worker.ts';

/** Reads the text that waits, and every other from then on. Shows nothing. */
export function Reader() {
  useEffect(
    () =>
      pasted.bring({
        readText,
        firstFrame,
        identityOf,
        meaningOf,
        start: (take, ended) => startWorker('reader', take, (why) => ended(why === 'died')),
      }),
    [],
  );
  return null;
}

const meaningOf = (reading: TextReading, draft: Draft) =>
  inputMeaning(reading, {
    draft,
    convention: page.addressing.value.convention,
    device: allDevices.chosen.value,
    devices: [...builtInProfiles, ...allDevices.own.value],
    own: valueStore.units.value.own,
  });
