import { Popover } from '../../kit/popover.tsx';
import { part, Slot } from '../slot.tsx';
import { useWords } from '../words.ts';
import { device } from './naming.ts';

const list = part(
  ['devices', 'header'],
  () => import('./device-options.tsx'),
  ({ DeviceOptions }) => DeviceOptions,
);

interface MenuProps {
  /** What is shown while no device is chosen. */
  readonly none?: string;
  /** The name of the button, and of what it opens. */
  readonly label?: (name: string) => string;
}

/** The chosen device, and behind it the choice of another. The devices come when it is opened. */
export function DeviceMenu({ none, label }: MenuProps) {
  const words = useWords('page').page.device;
  const name = device.value?.name ?? none ?? words.none;
  return (
    <Popover
      class="device-menu"
      summary={<span class="device-name">{name}</span>}
      label={(label ?? words.chosen)(name)}
    >
      {(close) => <Slot part={list} with={{ onChosen: close }} />}
    </Popover>
  );
}
