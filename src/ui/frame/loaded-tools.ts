import { signal } from '@preact/signals';
import { loadToolWords, type ToolWords } from '../../words/index.ts';
import type * as ToolViews from './tools/index.ts';

interface Tools {
  readonly views: typeof ToolViews;
  readonly words: ToolWords;
}

/** The tools around a frame: copying, the expected reply, editing lists, lighting what belongs together. They come right behind the first view. */
export const tools = signal<Tools | undefined>(undefined);

export async function fetchTools(): Promise<void> {
  const [views, words] = await Promise.all([import('./tools/index.ts'), loadToolWords()]);
  const root = document.getElementById('app');
  if (root && !tools.value) views.linkLights(root);
  tools.value = { views, words };
}
