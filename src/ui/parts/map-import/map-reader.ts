import type { MapReader } from '../../../store/index.ts';
import type { MapTask, ReadMaps } from '../../../workbench/index.ts';
import { startWorker } from '../workers/start-worker.ts';

/** Reads each file in a worker of its own: one of 20,000 rows takes a second. */
export const mapReader: MapReader = {
  open(source) {
    const waiting: ((read: ReadMaps | undefined) => void)[] = [];
    let isOpen = true;
    const end = () => {
      isOpen = false;
      for (const answer of waiting.splice(0)) answer(undefined);
    };
    const worker = startWorker<MapTask, ReadMaps>('maps', (read) => waiting.shift()?.(read), end);
    worker.post({ kind: 'open', ...source });
    return {
      read: (answers) =>
        new Promise((done) => {
          if (!isOpen) return done(undefined);
          waiting.push(done);
          worker.post({ kind: 'read', answers });
        }),
      close() {
        worker.end();
        end();
      },
    };
  },
};
