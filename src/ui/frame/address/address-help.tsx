import type { Table } from '../../../modbus/index.ts';
import { zeroBasedAddress } from '../../../notation/index.ts';
import { addressQuantity, mayBeTrapped } from '../../../workbench/index.ts';
import { Popover } from '../../kit/popover.tsx';
import { part, Slot } from '../../parts/slot.tsx';
import { useSteady } from '../../parts/steady.ts';
import { draft, evaluation, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { DeviceAddressPlace } from '../device/device-place.tsx';
import { addresses } from './convention.ts';
import './address.css';

const traps = part(
  ['addressWays'],
  () => import('./address-traps.tsx'),
  ({ Traps }) => Traps,
);
const ways = part(
  ['addressWays'],
  () => import('./address-ways.tsx'),
  ({ Ways }) => Ways,
);
const convention = part(
  ['addressWays'],
  () => import('./address-ways.tsx'),
  ({ Convention }) => Convention,
);

interface HelpProps {
  readonly path: string;
  readonly label: string;
  /** What the frame's field has; it may have been typed in the manual's way. */
  readonly text: string;
  readonly table: Table;
}

/** What else a typed address may mean, how else it is written, and what the user's manual means by plain numbers. */
export function AddressHelp({ path, label, text, table }: HelpProps) {
  const words = useWords('tools').addresses;
  const trapped = useSteady(
    () => mayBeTrapped(text, addressQuantity(evaluation.value, path), { convention: addresses.convention.value }),
    [path, text],
  ).value;
  return (
    <div class="address-help">
      <div aria-live="polite">
        {trapped && <Slot part={traps} with={{ path, text, table, severity: 'warning' as const }} />}
      </div>
      <DeviceAddressPlace
        path={path}
        label={label}
        text={text}
        table={table}
        onName={(name) => step(addresses.withTyped(draft.value, path, name, table))}
      />
      <Popover summary={words.ways} label={words.waysOf(label)}>
        {() => (
          <div class="address-ways">
            <Slot part={ways} with={{ address: zeroBasedAddress(text), table }} />
            <Slot part={traps} with={{ path, text, table, severity: 'note' as const }} />
            <Slot part={convention} with={{ path, table }} />
          </div>
        )}
      </Popover>
    </div>
  );
}
