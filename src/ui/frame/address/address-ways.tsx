import { functionsOf, LAST_ADDRESS, type Table } from '../../../modbus/index.ts';
import { addressConventions, printedAddress, writeAddress } from '../../../notation/index.ts';
import { Select } from '../../kit/choice.tsx';
import { saidId } from '../../kit/field.tsx';
import { registerNames } from '../../parts/device/naming.ts';
import { useWords } from '../../parts/words.ts';
import { addresses } from './convention.ts';
import './address-ways.css';

interface WaysProps {
  readonly address: number | undefined;
  readonly table: Table;
}

/** An address in every notation and by its name, and the functions of its table. */
export function Ways({ address, table }: WaysProps) {
  const words = useWords('addressWays');
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
  const words = useWords('addressWays');
  const id = `convention-${path}`;
  const printed = (address: number) => printedAddress(addresses.convention.value, table, address);
  return (
    <>
      <label for={id}>{words.convention}</label>
      <Select
        id={id}
        wrong={false}
        value={addresses.convention.value}
        options={addressConventions.map((value) => ({ value, name: words.conventions[value] }))}
        onChoose={(chosen) => {
          addresses.convention.value = chosen;
        }}
      />
      <p id={saidId(id)} aria-live="polite">
        {words.check(table, printed(0), printed(1))}
      </p>
    </>
  );
}
