import { fieldValue, functionsOf, LAST_ADDRESS, quantityOf, type Table } from '../../../modbus/index.ts';
import {
  type AddressConvention,
  type AddressRepair,
  type AddressTrap,
  addressConventions,
  addressMeant,
  addressTraps,
  printedAddress,
  writeAddress,
  zeroBasedAddress,
} from '../../../notation/index.ts';
import { type Draft, type Evaluation, withText } from '../../../workbench/index.ts';
import { Fold } from '../../kit/fold.tsx';
import { registerNames } from '../../parts/device/naming.ts';
import { useSteady } from '../../parts/steady.ts';
import { draft, evaluation, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { DeviceAddressPlace } from '../device/device-place.tsx';
import { addresses } from './convention.ts';
import './address.css';

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
      <Fold summary={words.ways} label={words.waysOf(label)}>
        {() => (
          <>
            <Ways address={zeroBasedAddress(text)} table={table} />
            {lines('note')}
            <Convention path={path} table={table} />
          </>
        )}
      </Fold>
    </div>
  );
}

function trapsOf(draft: Draft, path: string, text: string, table: Table, evaluated: Evaluation) {
  const { description, frame, controls } = evaluated;
  const typed = addresses.shown(draft, path, text, table).text;
  // A device's name is in no trap; the address it stands for may be.
  const asManual = typed !== text && addressMeant(typed, addresses.convention.value, table) !== undefined;
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
    <div class="trap" data-severity={trap.severity}>
      <p>{words.trap(trap)}</p>
      {trap.repairs.map((by) => (
        <button key={words.repair(by)} type="button" onClick={() => onRepair(by)}>
          {words.repair(by)}
        </button>
      ))}
    </div>
  );
}

interface WaysProps {
  readonly address: number | undefined;
  readonly table: Table;
}

/** An address in every notation and by its name, and the functions of its table. */
function Ways({ address, table }: WaysProps) {
  const words = useWords('tools').addresses;
  if (address === undefined || !Number.isInteger(address) || address < 0 || address > LAST_ADDRESS) {
    return <p>{words.notAnAddress}</p>;
  }
  const { nameAt, device = '' } = registerNames.value ?? {};
  const name = nameAt?.(table, address);
  return (
    <>
      <p>{words.element(table, address)}</p>
      <dl>
        {writeAddress(table, address).map(({ notation, text }) => (
          <div key={notation}>
            <dt>{words.notations[notation]}</dt>
            <dd class="mono">{text}</dd>
          </div>
        ))}
        {name && (
          <div>
            <dt>{words.nameIn(device)}</dt>
            <dd>{name}</dd>
          </div>
        )}
      </dl>
      <p>{words.functions(functionsOf(table).map(({ code }) => code))}</p>
    </>
  );
}

interface ConventionProps {
  readonly path: string;
  readonly table: Table;
}

/** How the manual prints addresses, with what tells whether that is right. */
function Convention({ path, table }: ConventionProps) {
  const words = useWords('tools').addresses;
  const id = `convention-${path}`;
  const printed = (address: number) => printedAddress(addresses.convention.value, table, address);
  return (
    <>
      <label for={id}>{words.convention}</label>
      <select
        id={id}
        aria-describedby={`${id}-check`}
        value={addresses.convention.value}
        onChange={({ currentTarget }) => (addresses.convention.value = currentTarget.value as AddressConvention)}
      >
        {addressConventions.map((known) => (
          <option key={known} value={known}>
            {words.conventions[known]}
          </option>
        ))}
      </select>
      <p id={`${id}-check`} aria-live="polite">
        {words.check(table, printed(0), printed(1))}
      </p>
    </>
  );
}
