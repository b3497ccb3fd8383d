import type { ComponentType } from 'preact';
import './poll.css';
import { refresh } from '../device/chosen.ts';
import { loadWords as loadDeviceWords } from '../device/language.ts';
import { loadWords } from './language.ts';
import { PollPanel } from './poll-panel.tsx';

/** The panel with its words. A device that is chosen in it names frames too, for which the words of devices are needed. */
export async function loadPanel(): Promise<ComponentType> {
  await Promise.all([loadWords(), loadDeviceWords()]);
  refresh();
  return PollPanel;
}
