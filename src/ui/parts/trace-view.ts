import { decodeFrame } from '../../modbus/index.ts';
import { TraceView } from '../../store/index.ts';
import { page } from './store.ts';
import { startWorker } from './workers/start-worker.ts';

/** A trace with a worker of its own. The frame of the row that is chosen becomes the current one; then `chosen` is called. */
export const traceView = (chosen?: () => void): TraceView<File> =>
  new TraceView<File>({
    start: (take, ended) => startWorker('trace', take, ended),
    show: ({ bytes, transport, side, request, reply }) => {
      const direction = side ?? 'request';
      page.showReading(decodeFrame(bytes, { transport, direction, request }), request, 'wait', reply);
      chosen?.();
    },
  });
