import { Popover } from '../../kit/popover.tsx';
import { part, Slot } from '../slot.tsx';
import { useWords } from '../words.ts';
import { device } from './naming.ts';

const list = part(
  ['devices'],
  () => import('./device-options.tsx'),
  ({ DeviceOptions }) => DeviceOptions,
);

/** The chosen device, and behind it the choice of another. The devices come when it is opened. */
export function DeviceMenu() {
  const words = useWords('page').page.device;
  const name = device.value?.name ?? words.none;
  return (
    <Popover class="device-menu" summary={name} label={words.chosen(name)}>
      {(close) => <Slot part={list} with={{ onChosen: close }} />}
    </Popover>
  );
}
