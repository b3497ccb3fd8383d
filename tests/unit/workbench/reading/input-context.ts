import { builtInProfiles } from '../../../../src/devices/index.ts';
import { type Draft, firstDraft, type InputContext } from '../../../../src/workbench/index.ts';

/** What a text is read with: no device is chosen unless one is named by its id. */
export const inputContext = (draft: Draft = firstDraft, device?: string): InputContext => ({
  draft,
  convention: 'protocol',
  device: builtInProfiles.find(({ id }) => id === device),
  devices: builtInProfiles,
  own: undefined,
  line: { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 },
});
