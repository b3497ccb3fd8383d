import type { ComponentType } from 'preact';
import { loadWords } from './language.ts';
import { SequencePanel } from './sequence-panel.tsx';
import './sequence.css';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return SequencePanel;
}
