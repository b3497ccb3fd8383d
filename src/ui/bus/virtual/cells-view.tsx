import { Component } from 'preact';
import { type DeviceSetup, profileOf, type WatchedCells } from '../../../bus/index.ts';
import {
  type EntityTable,
  entityTables,
  isBitTable,
  lineName,
  nameAt,
  namedValues,
  type Profile,
} from '../../../devices/index.ts';
import { LAST_ADDRESS } from '../../../modbus/index.ts';
import { formatHex } from '../../../notation/index.ts';
import { kindName } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { deviceWords } from '../../parts/device/device-words.ts';
import { virtual } from '../virtual-devices.ts';
import { NumberCell } from './number-cell.tsx';
import { virtualWords as words } from './virtual-words.ts';

interface CellsProps {
  readonly device: DeviceSetup;
  readonly cells: WatchedCells | undefined;
  /** Whether the devices are on a line, so that what stands in them is known. */
  readonly live: boolean;
}

interface CellsState {
  readonly table: EntityTable;
  readonly from: number;
}

/** Addresses shown at once. */
const SHOWN = 16;
const WORD = 0xffff;
const LEAST_SIGNED = -0x8000;

/** What stands in one device, as it changes, to be changed. */
export class CellsView extends Component<CellsProps, CellsState> {
  override state: CellsState = firstPlace(this.props.device);

  override componentDidMount() {
    this.watch();
  }

  override componentDidUpdate(_: CellsProps, before: CellsState) {
    if (before.table !== this.state.table || before.from !== this.state.from) this.watch();
  }

  private watch() {
    virtual.watch({ kind: 'watch', id: this.props.device.id, count: SHOWN, ...this.state });
  }

  private go(from: number, table = this.state.table) {
    this.setState({ table, from: Math.max(0, Math.min(LAST_ADDRESS - SHOWN + 1, from)) });
  }

  private write(address: number, value: number) {
    const { table } = this.state;
    virtual.order({ kind: 'write', id: this.props.device.id, table, from: address, values: [value & WORD] });
  }

  render() {
    const { device, cells, live } = this.props;
    const { table, from } = this.state;
    const text = words.cells;
    const profile = profileOf(device);
    return (
      <section aria-labelledby="virtual-cells">
        <h3 id="virtual-cells">{text.heading(kindName(device, words.models), device.unit)}</h3>
        {live ? (
          <>
            <div class="tools">
              <label>
                {text.table}{' '}
                <Select
                  value={table}
                  options={entityTables.map((value) => ({ value, name: words.tables[value] }))}
                  onChoose={(wanted) => this.go(firstIn(profile, wanted), wanted)}
                />
              </label>
              {profile && <Jump profile={profile} onGo={(table, address) => this.go(address, table)} />}
              <NumberCell
                label={text.from}
                shown
                value={from}
                least={0}
                most={LAST_ADDRESS}
                wrong={text.fromWrong}
                onChange={(from) => this.go(from)}
              />
              <button type="button" disabled={from === 0} onClick={() => this.go(from - SHOWN)}>
                {text.before}
              </button>
              <button type="button" disabled={from > LAST_ADDRESS - SHOWN} onClick={() => this.go(from + SHOWN)}>
                {text.next}
              </button>
            </div>
            {cells && cells.id === device.id && this.rows(cells, profile)}
            {cells && cells.id === device.id && <Counters cells={cells} />}
          </>
        ) : (
          <p class="said">{text.notConnected}</p>
        )}
      </section>
    );
  }

  private rows({ table, from, values }: WatchedCells, profile: Profile | undefined) {
    const text = words.cells;
    const bits = isBitTable(table);
    const known = values.map((value) => value ?? 0);
    const named = profile ? namedValues(profile, table, from, known) : [];
    if (values.every((value) => value === undefined)) return <p class="said">{text.absent}</p>;
    return (
      <table class="cells">
        <thead>
          <tr>
            <th scope="col">{text.address}</th>
            <th scope="col">{text.value}</th>
            {!bits && <th scope="col">{text.hex}</th>}
            <th scope="col">{text.name}</th>
          </tr>
        </thead>
        <tbody>
          {values.map((value, index) => {
            if (value === undefined) return null;
            const address = from + index;
            const means = named.filter(({ at }) => at === index);
            return (
              <tr key={address}>
                <th scope="row" class="mono">
                  {address} <span class="said">{formatHex(address, 4)}</span>
                </th>
                <td>
                  {bits ? (
                    <input
                      type="checkbox"
                      checked={value !== 0}
                      aria-label={text.bitOf(address)}
                      onChange={({ currentTarget }) => this.write(address, currentTarget.checked ? 1 : 0)}
                    />
                  ) : (
                    <NumberCell
                      label={text.valueOf(address)}
                      value={value}
                      least={LEAST_SIGNED}
                      most={WORD}
                      wrong={text.valueWrong}
                      onChange={(value) => this.write(address, value)}
                    />
                  )}
                </td>
                {!bits && <td class="mono">{formatHex(value, 4)}</td>}
                <td>
                  {means.length > 0
                    ? means.map((one) => deviceWords.named(one)).join(' ')
                    : profile && nameAt(profile, table, address)}
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
    );
  }
}

interface JumpProps {
  readonly profile: Profile;
  readonly onGo: (table: EntityTable, address: number) => void;
}

/** The registers of a device by name. */
function Jump({ profile, onGo }: JumpProps) {
  return (
    <label>
      {words.cells.jump}{' '}
      <select
        value=""
        onChange={({ currentTarget }) => {
          const register = profile.registers[Number(currentTarget.value)];
          currentTarget.value = '';
          if (register) onGo(register.table, register.address);
        }}
      >
        <option value="">{words.cells.jumpNone}</option>
        {profile.registers.map((register, index) => (
          <option key={index} value={index}>
            {lineName(register)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** What the device has counted, for the functions 08, 0B and 0C. */
function Counters({ cells: { counts, eventCount, listenOnly } }: { readonly cells: WatchedCells }) {
  const text = words.cells;
  return (
    <>
      <h4>{text.counters}</h4>
      <dl class="counters">
        {(Object.keys(counts) as readonly (keyof typeof counts)[]).map((name) => (
          <div key={name}>
            <dt>{text.counterNames[name]}</dt>
            <dd>{counts[name]}</dd>
          </div>
        ))}
        <div>
          <dt>{text.events}</dt>
          <dd>{eventCount}</dd>
        </div>
      </dl>
      {listenOnly && <p class="said">{text.listenOnly}</p>}
    </>
  );
}

/** The first address of a table that has a name. */
function firstIn(profile: Profile | undefined, table: EntityTable): number {
  const named = profile?.registers.filter((register) => register.table === table) ?? [];
  return named.length === 0 ? 0 : Math.min(...named.map(({ address }) => address));
}

/** Where something stands first: holding registers that have names. */
const firstPlace = (device: DeviceSetup): CellsState => {
  const table = 'holding-register';
  return { table, from: firstIn(profileOf(device), table) };
};
