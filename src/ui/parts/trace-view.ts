import { decodeFrame } from '../../modbus/index.ts';
import { TraceView } from '../../store/index.ts';
import type { TraceTask } from '../../workbench/index.ts';
import { page } from './store.ts';
import { onceAFrame } from './workers/once-a-frame.ts';
import { startWorker } from './workers/start-worker.ts';

/** A trace with a worker of its own. The frame of the row that is chosen becomes the current one; then `chosen` is called. */
export const traceView = (chosen?: () => void): TraceView<File> =>
  new TraceView<File>({
    start(take, ended) {
      const mail = onceAFrame(take);
      const worker = startWorker<TraceTask<File>, Parameters<typeof take>[0]>('trace', mail.take, (why) => {
        mail.stop();
        ended(why);
      });
      return {
        post: worker.post,
        end() {
          mail.stop();
          worker.end();
        },
      };
    },
    show: ({ bytes, transport, side, request, reply }) => {
      // Words in no frame have no bytes.
      if (bytes.length === 0) return;
      const direction = side ?? 'request';
      page.showReading(decodeFrame(bytes, { transport, direction, request }), request, 'wait', reply);
      chosen?.();
    },
  });
