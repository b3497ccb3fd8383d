import { zeroBasedAddress } from '../../../notation/index.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { device, devicesWanted } from '../../parts/device/naming.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';
import type { DeviceAddressProps } from './device-address.tsx';

const panel = part(
  ['devices'],
  () => import('./device-panel.tsx'),
  ({ DevicePanel }) => DevicePanel,
);
const address = part(
  ['devices'],
  () => import('./device-address.tsx'),
  ({ DeviceAddress }) => DeviceAddress,
);

/** The device that is spoken to: the devices come when this is opened. */
export const DevicePlace = () => (
  <FoldPanel class="device-panel" keep title={useWords('page').views.panels.device} hint={device.value?.name}>
    {() => <Slot part={panel} with={{}} />}
  </FoldPanel>
);

/** Where devices have something to say about an address: one is chosen, or what is typed may be a name in one of them. */
export function DeviceAddressPlace(props: DeviceAddressProps) {
  const { text } = props;
  const isName = text.trim() !== '' && zeroBasedAddress(text) === undefined;
  return (isName || devicesWanted.value) && <Slot part={address} with={props} />;
}
