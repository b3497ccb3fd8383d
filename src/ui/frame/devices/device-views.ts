import './devices.css';
import { refresh, speakToKnown } from '../../parts/device/chosen.ts';
import { loadWords as loadSentences } from '../../parts/device/device-words.ts';
import { onDevice } from '../../state/draft.ts';

export { DeviceAddress } from './device-address.tsx';
export { DevicePanel } from './device-panel.tsx';

/** Loads the sentences, then names frames by the device chosen last. */
export async function loadWords(): Promise<void> {
  await loadSentences();
  refresh();
  onDevice(speakToKnown);
}
