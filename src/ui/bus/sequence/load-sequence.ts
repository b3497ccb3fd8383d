import type { ComponentType } from 'preact';
import { SequencePanel } from './sequence-panel.tsx';
import { loadWords } from './sequence-words.ts';
import './sequence.css';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return SequencePanel;
}
