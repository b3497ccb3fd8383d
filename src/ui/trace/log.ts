import { decodeFrame } from '../../modbus/index.ts';
import { TraceView } from '../../store/index.ts';
import { page } from '../parts/store.ts';
import { startWorker } from '../parts/workers/start-worker.ts';

/** The trace of the Log view, which stays while other views are open. */
export const log = new TraceView<File>({
  start: (take, ended) => startWorker('trace', take, ended),
  show: ({ bytes, transport, side, request, reply }) => {
    const direction = side ?? 'request';
    page.showReading(decodeFrame(bytes, { transport, direction, request }), request, 'wait', reply);
  },
});
