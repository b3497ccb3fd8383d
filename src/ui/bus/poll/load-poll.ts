import type { ComponentType } from 'preact';
import './poll.css';
import { refresh } from '../../parts/device/chosen.ts';
import { loadWords as loadDeviceWords } from '../../parts/device/device-words.ts';
import { PollPanel } from './poll-panel.tsx';
import { loadWords } from './poll-words.ts';

/** The panel with its words. A device that is chosen in it names frames too, for which the words of devices are needed. */
export async function loadPanel(): Promise<ComponentType> {
  await Promise.all([loadWords(), loadDeviceWords()]);
  refresh();
  return PollPanel;
}
