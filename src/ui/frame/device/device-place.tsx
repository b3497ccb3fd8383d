import { zeroBasedAddress } from '../../../notation/index.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { device, devicesWanted } from '../../parts/device/naming.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';
import type { DeviceAddressProps } from './device-address.tsx';

const panel = part(
  ['devices'],
  () => import('../../parts/device-panel/device-panel.tsx'),
  ({ DevicePanel }) => DevicePanel,
);
const address = part(
  ['devices'],
  () => import('./device-address.tsx'),
  ({ DeviceAddress }) => DeviceAddress,
);

/** The panel of the chosen device. The devices come when it is opened. */
export const DevicePlace = () => (
  <FoldPanel class="device-panel" keep title={useWords('page').page.panels.device.title} hint={device.value?.name}>
    {() => <Slot part={panel} with={{}} />}
  </FoldPanel>
);

/** The place below an address field for what devices know: one is chosen, or the text may be a name in one of them. */
export function DeviceAddressPlace(props: DeviceAddressProps) {
  const { text } = props;
  const isName = text.trim() !== '' && zeroBasedAddress(text) === undefined;
  return (isName || devicesWanted.value) && <Slot part={address} with={props} />;
}
