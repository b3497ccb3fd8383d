import { fetchComplaints } from './language.ts';
import { fetchTools } from './lazy.ts';
import { loadReadPanel } from './load.ts';

const Nothing = () => null;

/** What comes whatever is shown, and has its own places: sentences, tools, and reading, which is listened for everywhere. */
export const loadBehind = async () => {
  await Promise.all([fetchComplaints(), fetchTools(), loadReadPanel()]);
  return Nothing;
};
