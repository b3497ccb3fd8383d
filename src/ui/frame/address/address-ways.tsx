import { functionsOf, LAST_ADDRESS, type Table } from '../../../modbus/index.ts';
import { type AddressConvention, addressConventions, printedAddress, writeAddress } from '../../../notation/index.ts';
import { registerNames } from '../../parts/device/naming.ts';
import { useWords } from '../../parts/words.ts';
import { addresses } from './convention.ts';

interface WaysProps {
  readonly address: number | undefined;
  readonly table: Table;
}

/** An address in every notation and by its name, and the functions of its table. */
export function Ways({ address, table }: WaysProps) {
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
export function Convention({ path, table }: ConventionProps) {
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
