import { useEffect, useState } from 'preact/hooks';
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
import { formatHex, wholeNumber } from '../../../notation/index.ts';
import { kindName } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { disabledFor } from '../../kit/disabled-for.ts';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import '../../kit/table.css';

interface CellsProps {
  readonly device: DeviceSetup;
  /** Whether the devices are on a line: only then are their contents known. */
  readonly live: boolean;
}

/** Addresses shown at once. */
const SHOWN = 16;
const WORD = 0xffff;
const LEAST_SIGNED = -0x8000;

/** The contents of one device, which can be changed. */
export function CellsView({ device, live }: CellsProps) {
  const { cells: text, models, tables } = useWords('virtual');
  const profile = profileOf(device);
  const [table, setTable] = useState<EntityTable>('holding-register');
  const [from, setFrom] = useState(() => firstIn(profile, table));
  const go = (to: number, wanted = table) => {
    setTable(wanted);
    setFrom(Math.max(0, Math.min(LAST_ADDRESS - SHOWN + 1, to)));
  };
  useEffect(
    () => bus.virtual.watch({ kind: 'watch', id: device.id, count: SHOWN, table, from }),
    [device.id, table, from],
  );
  return (
    <section aria-labelledby="virtual-cells">
      <h3 id="virtual-cells">{text.heading(kindName(device, models), device.unit)}</h3>
      {live ? (
        <>
          <div class="tools in-row">
            <label>
              {text.table}{' '}
              <Select
                value={table}
                options={entityTables.map((value) => ({ value, name: tables[value] }))}
                onChoose={(wanted) => go(firstIn(profile, wanted), wanted)}
              />
            </label>
            {profile && <Jump profile={profile} onGo={(wanted, address) => go(address, wanted)} />}
            <NumberEntry
              label={text.from}
              when="finished"
              value={from}
              read={wholeNumber(0, LAST_ADDRESS)}
              wrong={text.fromWrong}
              onValue={go}
            />
            <button
              type="button"
              {...disabledFor(from === 0 ? text.atFirst : undefined)}
              onClick={() => go(from - SHOWN)}
            >
              {text.before}
            </button>
            <button
              type="button"
              {...disabledFor(from > LAST_ADDRESS - SHOWN ? text.atLast : undefined)}
              onClick={() => go(from + SHOWN)}
            >
              {text.next}
            </button>
          </div>
          <Cells device={device} profile={profile} />
        </>
      ) : (
        <p class="said">{text.notConnected}</p>
      )}
    </section>
  );
}

/** The cells and counters, once the session has told them. */
function Cells({ device, profile }: { readonly device: DeviceSetup; readonly profile: Profile | undefined }) {
  const { absent } = useWords('virtual').cells;
  const { value: cells } = bus.virtual.cells;
  if (cells?.id !== device.id) return null;
  const isAbsent = cells.values.every((value) => value === undefined);
  return (
    <>
      {isAbsent ? <p class="said">{absent}</p> : <CellTable cells={cells} profile={profile} />}
      <Counters cells={cells} />
    </>
  );
}

interface TableProps {
  readonly cells: WatchedCells;
  readonly profile: Profile | undefined;
}

function CellTable({ cells: { id, table, from, values }, profile }: TableProps) {
  const text = useWords('virtual').cells;
  const device = useWords('devices');
  const bits = isBitTable(table);
  const known = values.map((value) => value ?? 0);
  const named = profile ? namedValues(profile, table, from, known) : [];
  const write = (address: number, value: number) =>
    bus.virtual.order({ kind: 'write', id, table, from: address, values: [value & WORD] });
  return (
    <div class="table cards tiles">
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
                      onChange={({ currentTarget }) => write(address, currentTarget.checked ? 1 : 0)}
                    />
                  ) : (
                    <NumberEntry
                      label={text.valueOf(address)}
                      bare
                      when="finished"
                      value={value}
                      read={wholeNumber(LEAST_SIGNED, WORD)}
                      wrong={text.valueWrong}
                      onValue={(value) => write(address, value)}
                    />
                  )}
                </td>
                {!bits && (
                  <td class="mono" data-column={text.hex}>
                    {formatHex(value, 4)}
                  </td>
                )}
                <td>
                  {means.length > 0
                    ? means.map((one) => device.named(one)).join(' ')
                    : profile && nameAt(profile, table, address)}
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

interface JumpProps {
  readonly profile: Profile;
  readonly onGo: (table: EntityTable, address: number) => void;
}

/** The registers of a device by name. */
function Jump({ profile, onGo }: JumpProps) {
  const text = useWords('virtual').cells;
  return (
    <label>
      {text.jump}{' '}
      <select
        value=""
        onChange={({ currentTarget }) => {
          const register = profile.registers[Number(currentTarget.value)];
          currentTarget.value = '';
          if (register) onGo(register.table, register.address);
        }}
      >
        <option value="">{text.jumpNone}</option>
        {profile.registers.map((register, index) => (
          <option key={index} value={index}>
            {lineName(register)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** The counters of the functions 08, 0B and 0C. */
function Counters({ cells: { counts, eventCount, listenOnly } }: { readonly cells: WatchedCells }) {
  const text = useWords('virtual').cells;
  return (
    <>
      <h4>{text.counters}</h4>
      <dl class="counters field-grid">
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

/** The first address of a table that has a name; 0 if none has. */
function firstIn(profile: Profile | undefined, table: EntityTable): number {
  const named = profile?.registers.filter((register) => register.table === table) ?? [];
  return named.length === 0 ? 0 : Math.min(...named.map(({ address }) => address));
}
