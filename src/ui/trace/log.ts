import { LogAddress } from '../../store/index.ts';
import { page } from '../parts/store.ts';
import { traceView } from '../parts/trace-view.ts';

/** The trace of the Log view, which stays while other views are open. */
export const log = traceView();

/** What the address says of it. */
export const logAddress = new LogAddress(page, log);
