import { traceView } from '../parts/trace-view.ts';

/** The trace of the Log view, which stays while other views are open. */
export const log = traceView();
