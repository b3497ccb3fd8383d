import { fetchComplaints } from '../parts/page-words.ts';
import { fetchTools } from './loaded-tools.ts';
import { loadReadPanel } from './panels.ts';

const Nothing = () => null;

/** What comes whatever is shown, and has its own places: sentences, tools, and reading, which is listened for everywhere. */
export const loadBehind = async () => {
  await Promise.all([fetchComplaints(), fetchTools(), loadReadPanel()]);
  return Nothing;
};
