import type { Complaints } from './en/complaints.ts';
import type { ToolWords } from './en/tools.ts';

/** The sentences about what is wrong, which a page does not need until something is. */
export const loadComplaints = (): Promise<Complaints> =>
  import('./en/complaints.ts').then(({ complaints }) => complaints);

/** The sentences of the tools around a frame, which come with the tools. */
export const loadToolWords = (): Promise<ToolWords> => import('./en/tools.ts').then(({ tools }) => tools);
