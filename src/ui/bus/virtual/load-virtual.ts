import type { ComponentType } from 'preact';
import { VirtualPanel } from './virtual-panel.tsx';
import { loadWords } from './virtual-words.ts';
import './virtual.css';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return VirtualPanel;
}
