import { fetchComplaints } from '../parts/page-words.ts';
import { fetchTools } from './loaded-tools.ts';

const Nothing = () => null;

/** What comes whatever is shown, and has its own places: sentences and tools. */
export const loadBehind = async () => {
  await Promise.all([fetchComplaints(), fetchTools()]);
  return Nothing;
};
