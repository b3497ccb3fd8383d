import type { ComponentType } from 'preact';
import { loadWords } from './language.ts';
import { VirtualPanel } from './virtual-panel.tsx';
import './virtual.css';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return VirtualPanel;
}
