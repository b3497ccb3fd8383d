import type { ComponentType } from 'preact';
import './scan.css';
import { ScanPanel } from './scan-panel.tsx';
import { loadWords } from './scan-words.ts';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return ScanPanel;
}
