import { fetchComplaints } from '../parts/page-words.ts';

const Nothing = () => null;

/** Sentences that come whatever is shown. */
export const loadBehind = async () => {
  await fetchComplaints();
  return Nothing;
};
