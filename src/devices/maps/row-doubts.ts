import type { MapNoticeCode } from './codes.ts';

/** What of a row nothing says, so that it is asked once for all rows. */
export type AssumedPart = 'type' | 'order' | 'text-length' | 'scale';

/** What is doubtful in a row. */
export interface RowDoubts {
  readonly notices: MapNoticeCode[];
  readonly assumed: AssumedPart[];
}
