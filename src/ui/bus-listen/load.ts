import type { ComponentType } from 'preact';
import './listen.css';
import { loadWords } from './language.ts';
import { ListenPanel } from './listen-panel.tsx';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return ListenPanel;
}
