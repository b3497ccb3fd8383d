import { fieldValue, quantityOf, type Table } from '../../../modbus/index.ts';
import {
  type AddressRepair,
  type AddressTrap,
  addressMeant,
  addressTraps,
  zeroBasedAddress,
} from '../../../notation/index.ts';
import { type Draft, type Evaluation, withText } from '../../../workbench/index.ts';
import { Popover } from '../../kit/popover.tsx';
import { part, Slot } from '../../parts/slot.tsx';
import { useSteady } from '../../parts/steady.ts';
import { draft, evaluation, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { DeviceAddressPlace } from '../device/device-place.tsx';
import { addresses } from './convention.ts';
import './address.css';

const ways = part(
  ['tools'],
  () => import('./address-ways.tsx'),
  ({ Ways }) => Ways,
);
const convention = part(
  ['tools'],
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
  const traps = useSteady(() => trapsOf(draft.value, path, text, table, evaluation.value), [path, text, table]).value;
  const lines = (severity: AddressTrap['severity']) =>
    traps
      .filter((trap) => trap.severity === severity)
      .map((trap) => <Trap key={trap.code} trap={trap} onRepair={(by) => step(repaired(draft.value, path, by))} />);
  return (
    <div class="address-help">
      <div aria-live="polite">{lines('warning')}</div>
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
            {lines('note')}
            <Slot part={convention} with={{ path, table }} />
          </div>
        )}
      </Popover>
    </div>
  );
}

function trapsOf(draft: Draft, path: string, text: string, table: Table, evaluated: Evaluation) {
  const { description, frame, controls } = evaluated;
  const typed = addresses.shown(draft, path, text, table).text;
  // A device's name is in no trap; the address it stands for may be.
  const { value: convention } = addresses.convention;
  const asManual = typed !== text && convention !== 'protocol' && addressMeant(typed, convention, table) !== undefined;
  const quantityName = quantityOf(path);
  const quantity = frame && quantityName ? fieldValue(frame.reading, quantityName) : undefined;
  return addressTraps(asManual ? typed : text, {
    functionCode: description.code,
    table,
    quantity: typeof quantity === 'number' ? quantity : undefined,
    quantityFree: controls.some((control) => control.path === quantityName && !control.derived),
    readAs: asManual ? addresses.convention.value : 'protocol',
    manual: addresses.convention.value,
  });
}

/** The draft after a repair of the address at `path`. */
function repaired(draft: Draft, path: string, by: AddressRepair): Draft {
  if (by.kind === 'quantity') return withText(draft, quantityOf(path) ?? path, String(by.quantity));
  const next = withText(draft, path, by.text);
  return by.kind === 'function' ? withText(next, 'functionCode', String(by.functionCode)) : next;
}

interface TrapProps {
  readonly trap: AddressTrap;
  readonly onRepair: (by: AddressRepair) => void;
}

function Trap({ trap, onRepair }: TrapProps) {
  const words = useWords('tools').addresses;
  return (
    <div class="trap edged" data-severity={trap.severity}>
      <p>{words.trap(trap)}</p>
      {trap.repairs.map((by) => (
        <button key={words.repair(by)} type="button" onClick={() => onRepair(by)}>
          {words.repair(by)}
        </button>
      ))}
    </div>
  );
}
