import { useMemo } from 'preact/hooks';
import { lineName, linesBehind, unitScale } from '../../../../devices/index.ts';
import type { Table } from '../../../../modbus/index.ts';
import {
  type Expected,
  entityNumber,
  findExpected,
  formatHex,
  readExpected,
  type ValueView,
  valuesAt,
} from '../../../../notation/index.ts';
import type { ValueWords } from '../../../../words/index.ts';
import { type FrameRegister, runsOf, shownViews } from '../../../../workbench/index.ts';
import { Choice } from '../../../kit/choice.tsx';
import { TextField } from '../../../kit/text-field.tsx';
import type { CurrentFrame } from '../../current-frame.ts';
import { device } from '../../device/naming.ts';
import { useSame } from '../../steady.ts';
import { valueStore } from '../../value-store.ts';
import { useWords } from '../../words.ts';
import { type OfferedScale, ScaleBox } from './scale-box.tsx';
import { ValueTables } from './value-tables.tsx';

/** Registers to choose from, around the one that is chosen: a frame that is too long has any number. */
const MOST_OFFERED = 1000;
/** Registers of the longest number. */
const MOST_IN_NUMBER = 4;
/** Places that are offered for the expected value. */
const MOST_FOUND = 6;
/** The best reasons first. */
const RANK = ['expected', 'expected-rounded', 'expected-scaled', 'printable', 'few-digits', 'small', 'ordinary-size'];

interface Place {
  readonly register: FrameRegister;
  readonly run: readonly FrameRegister[];
  /** Its place in the run. */
  readonly index: number;
}

/** The registers from a chosen one on, in every type and order, with those that look right. */
export function ValuesPanel({ frame }: CurrentFrame) {
  const words = useWords('values');
  const text = valueStore.expected.value;
  const runs = frame ? runsOf(frame.reading, frame.bytes) : [];
  const places = runs.flatMap((run) => run.map((register, index): Place => ({ register, run, index })));
  const at = Math.min(valueStore.first.value, places.length - 1);
  const place = places[at];
  const table = frame?.reading.description?.table;
  const registers = place?.run.slice(place.index) ?? [];
  const values = registers.map(({ value }) => value);
  const scaled = useSame({
    registers: values.slice(0, MOST_IN_NUMBER),
    offered: offeredScales(place?.register.address, table),
  });
  const scaleBox = useMemo(() => <ScaleBox {...scaled} />, [scaled]);
  if (place === undefined) return null;
  const expected = readExpected(text);
  const views = valuesAt(values, expected);
  const offered = Math.max(0, at - MOST_OFFERED / 2);
  const go = (to: number) => {
    valueStore.first.value = to;
  };
  return (
    <>
      <div class="values-inputs in-row">
        <Choice
          id="values-first"
          label={words.first}
          value={at}
          options={places.slice(offered, offered + MOST_OFFERED).map((each, behind) => ({
            value: offered + behind,
            name: words.register(
              nameOf(each, table, words),
              `${each.register.value}, ${formatHex(each.register.value, 4)}`,
            ),
          }))}
          onChoose={go}
        />
        <TextField
          id="values-expected"
          label={words.expected}
          text={text}
          hint={words.expectedHint}
          onText={(typed) => {
            valueStore.expected.value = typed;
          }}
        />
      </div>
      <Marked views={views} registers={registers} />
      {expected && <Found places={places} at={at} expected={expected} table={table} onGo={go} />}
      <RareTypes />
      <ValueTables views={shownViews(views, valueStore.rare.value)} registers={registers} />
      {scaleBox}
    </>
  );
}

/** Whether the tables have types that few devices have. */
function RareTypes() {
  const words = useWords('values');
  const { rare } = valueStore;
  return (
    <button
      type="button"
      class="rare"
      aria-pressed={rare.value}
      onClick={() => {
        rare.value = !rare.value;
      }}
    >
      {words.rare}
    </button>
  );
}

/** The scales that the device chosen has for a register. */
function offeredScales(address: number | undefined, table: Table | undefined): readonly OfferedScale[] {
  const profile = device.value;
  if (profile === undefined || address === undefined || table === undefined || table === 'file-record') return [];
  return linesBehind(profile, table, address, 0).flatMap((line) => {
    const known = unitScale(line);
    return known ? [{ name: lineName(line), known }] : [];
  });
}

/** A register as manuals number it, or by its place in the list. */
function nameOf({ register: { address, record }, index }: Place, table: Table | undefined, words: ValueWords): string {
  if (record) return words.record(record.file, record.record);
  return address === undefined ? words.inList(index) : words.address(address, table && entityNumber(table, address));
}

interface MarkedProps {
  readonly views: readonly ValueView[];
  readonly registers: readonly FrameRegister[];
}

/** The values that look right, each with the reason. */
function Marked({ views, registers }: MarkedProps) {
  const words = useWords('values');
  const rank = ({ likely }: ValueView) => RANK.indexOf(likely?.code ?? '');
  const marked = views.filter(({ likely }) => likely).toSorted((a, b) => rank(a) - rank(b));
  return (
    <div aria-live="polite">
      <h3 id="marked">{words.marked}</h3>
      {marked.length === 0 ? (
        <p class="said">{words.notMarked}</p>
      ) : (
        <ul class="marked edges stack" aria-labelledby="marked">
          {marked.map((view) => (
            <li
              key={`${view.type}-${view.order}`}
              data-kind="registers"
              data-from={registers[0]?.from}
              data-to={registers[view.registers - 1]?.to}
            >
              <b class="mono">{view.text}</b> {view.type} {view.order}{' '}
              <span class="said">{view.likely && words.likely(view.likely)}</span>
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}

interface FoundProps {
  readonly places: readonly Place[];
  readonly at: number;
  readonly expected: Expected;
  readonly table: Table | undefined;
  readonly onGo: (at: number) => void;
}

/** Where else the expected value begins. */
function Found({ places, at, expected, table, onGo }: FoundProps) {
  const words = useWords('values');
  const found = places.flatMap(({ run, index }, start) =>
    index > 0
      ? []
      : findExpected(
          run.map(({ value }) => value),
          expected,
        ).map((one) => ({ to: start + one.at, view: one.view })),
  );
  if (found.length === 0) return <p class="said">{words.notFound}</p>;
  const elsewhere = found.filter(({ to }) => to !== at).slice(0, MOST_FOUND);
  if (elsewhere.length === 0) return null;
  return (
    <>
      <h3>{words.elsewhere}</h3>
      <ul class="marked edges stack">
        {elsewhere.map(({ to, view }) => (
          <li key={`${to}-${view.type}-${view.order}`}>
            <b class="mono">{view.text}</b> {view.type} {view.order}{' '}
            <button type="button" onClick={() => onGo(to)}>
              {words.goTo(nameOf(places[to] as Place, table, words))}
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}
