import type { ComponentType } from 'preact';
import './poll.css';
import { loadDevices } from '../../parts/device/chosen.ts';
import { PollPanel } from './poll-panel.tsx';
import { loadWords } from './poll-words.ts';

/** The panel with its words. A device that is chosen in it names frames too. */
export async function loadPanel(): Promise<ComponentType> {
  await Promise.all([loadWords(), loadDevices()]);
  return PollPanel;
}
