import { useEffect, useMemo, useState } from 'preact/hooks';
import { isBitTable, type Profile } from '../../../devices/index.ts';
import { entityNumber } from '../../../notation/index.ts';
import {
  filterOfKnown,
  type KnownColumn,
  type KnownColumns,
  knownAt,
  knownCsv,
  knownName,
  knownShown,
  knownUnits,
  profileOfKnown,
} from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { disabledFor } from '../../kit/disabled-for.ts';
import { download, timedName } from '../../kit/download.ts';
import { VirtualList } from '../../kit/virtual-list.tsx';
import { device } from '../../parts/device/naming.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { timeKind, timeText } from '../../parts/trace-rows/row-time.ts';
import { useWords } from '../../parts/words.ts';
import { Counting, OfWholeLog, type TraceTabProps } from './trace-tab.tsx';

const madeDevice = part(
  ['devices'],
  () => import('./made-device.tsx'),
  ({ MadeDevice }) => MadeDevice,
);

/** The columns that have a head; what was read and written says itself how often. */
const HEADS = ['unit', 'address', 'name', 'value', 'means', 'when'] as const satisfies readonly KnownColumn[];

/** In a narrower list, in pixels, a value has two lines. */
const NARROW = 760;

/** The registers and bits of each unit, as they became known. */
export function ValuesTab({ of, open, toRows }: TraceTabProps) {
  const words = useWords('trace').tabs;
  useEffect(() => {
    if (open) of.tabs.want({ kind: 'values' });
  }, [of, open]);
  const known = of.tabs.known.value;
  if (known === undefined) return <Counting />;
  if (known.count === 0) return <p class="said">{words.values.none}</p>;
  return <Known of={of} known={known} toRows={toRows} />;
}

interface KnownProps extends Pick<TraceTabProps, 'of' | 'toRows'> {
  readonly known: KnownColumns;
}

function Known({ of, known, toRows }: KnownProps) {
  const { values: words } = useWords('trace').tabs;
  const units = useMemo(() => knownUnits(known), [known]);
  const [wanted, setUnit] = useState<number>();
  const [changed, setChanged] = useState(false);
  const [chosen, choose] = useState(-1);
  const unit = wanted ?? (units.length === 1 ? units[0] : undefined);
  const places = useMemo(() => knownShown(known, { unit, changed }), [known, unit, changed]);
  const profile = device.value;
  const filter = (row: number) => {
    const at = places[row];
    if (at === undefined) return;
    of.setFilter(filterOfKnown(of.filter.peek(), knownAt(known, at)));
    toRows();
  };
  const save = () => {
    const state = of.state.peek();
    const clock = state.kind === 'open' ? state.clock : undefined;
    download(knownCsv(known, places, profile, words, clock), timedName('values', 'csv'), 'text/csv');
  };
  return (
    <>
      <div class="in-row trace-known-tools">
        {units.length > 1 && (
          <label>
            {words.unit}{' '}
            <Select
              value={unit === undefined ? '' : String(unit)}
              options={[
                { value: '', name: words.allUnits },
                ...units.map((one) => ({ value: String(one), name: String(one) })),
              ]}
              onChoose={(one) => setUnit(one === '' ? undefined : Number(one))}
            />
          </label>
        )}
        <label>
          <input
            type="checkbox"
            checked={changed}
            onChange={({ currentTarget }) => setChanged(currentTarget.checked)}
          />{' '}
          {words.changed}
        </label>
        <button type="button" onClick={save}>
          {words.save}
        </button>
        <DeviceButton of={of} known={known} unit={unit} />
      </div>
      {places.length === 0 ? (
        <p class="said">{words.noneChanged}</p>
      ) : (
        <div class={profile ? 'trace-known-frame named' : 'trace-known-frame'}>
          <div class="trace-head" aria-hidden="true">
            {HEADS.map((column) => (
              <span key={column} class={column === 'value' ? 'number' : column}>
                {words.columns[column]}
              </span>
            ))}
          </div>
          <VirtualList
            id="trace-known"
            class="trace-known"
            label={words.count(places.length)}
            breaksBelow={NARROW}
            count={places.length}
            chosen={chosen}
            of={`${unit} ${changed}`}
            onChoose={(row, how) => (how === 'key' ? choose(row) : filter(row))}
            onEnter={filter}
          >
            {(row) => <KnownRow of={of} known={known} at={places[row] ?? 0} />}
          </VirtualList>
        </div>
      )}
      <p class="said">{words.hint}</p>
      <OfWholeLog of={of} />
    </>
  );
}

function KnownRow({ of, known, at }: Pick<KnownProps, 'of' | 'known'> & { readonly at: number }) {
  const { values: words } = useWords('trace').tabs;
  const { unit, table, address, value, time, reads, writes, changes } = knownAt(known, at);
  const named = knownName(known, at, device.value);
  return (
    <>
      <span class="unit">{words.unitName(unit)}</span>
      <span class="mono" title={words.table(table)}>
        {entityNumber(table, address)}
      </span>
      <span class="name">{named?.name}</span>
      <span class="mono number">{isBitTable(table) ? words.bit(value) : value}</span>
      <span class="means">{named?.value && words.inUnits(named.value)}</span>
      <span class="when">
        {time !== undefined && timeText({ time, since: time - known.origin }, timeKind.value, of.state.value)}
      </span>
      <span class="counts">
        {[
          ...(reads > 0 ? [words.reads(reads)] : []),
          ...(writes > 0 ? [words.writes(writes)] : []),
          ...(changes > 0 ? [words.changes(changes)] : []),
        ].join(', ')}
      </span>
    </>
  );
}

/** Makes a device of what is known of a unit, which is the chosen one then. */
function DeviceButton({ of, known, unit }: Pick<KnownProps, 'of' | 'known'> & { readonly unit: number | undefined }) {
  const { values: words } = useWords('trace').tabs;
  const [profile, setProfile] = useState<Profile>();
  const make = () => {
    if (unit === undefined) return;
    const state = of.state.peek();
    const file = 'name' in state ? state.name : undefined;
    const texts = { name: words.deviceName(unit, file), source: words.deviceSource(file) };
    setProfile(profileOfKnown(known, unit, device.peek(), texts));
  };
  return (
    <>
      <button type="button" onClick={make} {...disabledFor(unit === undefined ? words.chooseUnit : undefined)}>
        {words.makeDevice(unit)}
      </button>
      <div role="status">{profile && <Slot part={madeDevice} with={{ profile }} />}</div>
    </>
  );
}
