import type { ComponentType } from 'preact';
import './scan.css';
import { loadWords } from './language.ts';
import { ScanPanel } from './scan-panel.tsx';

/** The panel with its words. */
export async function loadPanel(): Promise<ComponentType> {
  await loadWords();
  return ScanPanel;
}
