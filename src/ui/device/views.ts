import './devices.css';
import { onDevice } from '../state.ts';
import { refresh, speakToKnown } from './chosen.ts';
import { loadWords as loadSentences } from './language.ts';

export { DeviceAddress } from './device-address.tsx';
export { DevicePanel } from './device-panel.tsx';

/** Loads the sentences, then names frames by the device chosen last. */
export async function loadWords(): Promise<void> {
  await loadSentences();
  refresh();
  onDevice(speakToKnown);
}
