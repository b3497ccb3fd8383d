import type { Complaints } from './en-complaints.ts';

export { en, type Words } from './en.ts';
export type { Complaints, InputError } from './en-complaints.ts';

/** The sentences about what is wrong, which a page does not need until something is. */
export const loadComplaints = (): Promise<Complaints> =>
  import('./en-complaints.ts').then(({ complaints }) => complaints);
