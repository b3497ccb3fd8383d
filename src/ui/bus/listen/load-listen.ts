import type { ComponentType } from 'preact';
import './listen.css';
import { ListenPanel } from './listen-panel.tsx';
import { loadWords } from './listen-words.ts';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return ListenPanel;
}
