import { lineName, linesBehind, unitScale } from '../../../devices/index.ts';
import type { Table } from '../../../modbus/index.ts';
import {
  entityNumber,
  findExpected,
  formatHex,
  readExpected,
  type ValueView,
  valuesAt,
} from '../../../notation/index.ts';
import { KeptChoice } from '../../../store/index.ts';
import { type FrameRegister, flag } from '../../../workbench/index.ts';
import { Choice } from '../../kit/choice.tsx';
import { DrawnWhenSeen } from '../../kit/drawn-when-seen.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { TextField } from '../../kit/text-field.tsx';
import { device } from '../../parts/device/naming.ts';
import { storage } from '../../parts/store.ts';
import { type OfferedScale, ScaleBox } from './scale-box.tsx';
import { ValueTables } from './value-tables.tsx';
import { valueWords as words } from './value-words.ts';

const isOpen = new KeptChoice(storage, 'values', true, flag);

/** Registers to choose from, around the one that is chosen: a frame that is too long has any number. */
const MOST_OFFERED = 1000;
/** Places that are offered for the expected value. */
const MOST_FOUND = 6;
/** The best reasons first. */
const RANK = ['expected', 'expected-rounded', 'expected-scaled', 'printable', 'few-digits', 'small', 'ordinary-size'];

interface PanelProps {
  readonly runs: readonly (readonly FrameRegister[])[];
  readonly table: Table | undefined;
}

interface PanelState {
  /** The chosen register, counted through all runs. */
  readonly at: number;
  readonly expected: string;
}

/** The registers from a chosen one on, in every type and order, with those that look right. */
export class ValuesPanel extends DrawnWhenSeen<PanelProps, HTMLDetailsElement, PanelState> {
  override state: PanelState = { at: 0, expected: '' };

  render() {
    return (
      <FoldPanel
        root={this.element}
        class="values"
        title={words.title}
        hint={words.intro}
        open={isOpen.value}
        onToggle={(open) => {
          isOpen.value = open;
        }}
      >
        {() => this.body()}
      </FoldPanel>
    );
  }

  private body() {
    const { runs, table } = this.props;
    const { expected: text } = this.state;
    const places = runs.flatMap((run) => run.map((register, index) => ({ register, index, run })));
    const at = Math.min(this.state.at, places.length - 1);
    const offered = Math.max(0, at - MOST_OFFERED / 2);
    const { run, index } = places[at] as (typeof places)[number];
    const registers = run.slice(index);
    const expected = readExpected(text);
    const views = valuesAt(
      registers.map(({ value }) => value),
      expected,
    );
    const nameAt = (place: number) => nameOf(places[place]?.register, places[place]?.index ?? 0, table);
    return (
      <>
        <div class="values-inputs">
          <Choice
            id="values-first"
            label={words.first}
            value={at}
            options={places.slice(offered, offered + MOST_OFFERED).map(({ register }, behind) => ({
              value: offered + behind,
              name: words.register(nameAt(offered + behind), `${register.value}, ${formatHex(register.value, 4)}`),
            }))}
            onChoose={(place) => this.setState({ at: place })}
          />
          <TextField
            id="values-expected"
            label={words.expected}
            text={text}
            hint={words.expectedHint}
            onText={(typed) => this.setState({ expected: typed })}
          />
        </div>
        <Marked views={views} registers={registers} />
        {expected && (
          <Found {...this.found(expected, at)} nameAt={nameAt} onGo={(place) => this.setState({ at: place })} />
        )}
        <ValueTables views={views} registers={registers} />
        <ScaleBox
          registers={registers.map(({ value }) => value)}
          offered={offeredScales(registers[0]?.address, table)}
        />
      </>
    );
  }

  /** Where else the expected value begins, and whether it is here. */
  private found(expected: NonNullable<ReturnType<typeof readExpected>>, at: number) {
    let before = 0;
    const all = this.props.runs.flatMap((run) => {
      const start = before;
      before += run.length;
      const values = run.map(({ value }) => value);
      return findExpected(values, expected).map((found) => ({ place: start + found.at, view: found.view }));
    });
    const elsewhere = all.filter(({ place }) => place !== at).slice(0, MOST_FOUND);
    return { none: all.length === 0, elsewhere };
  }
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
function nameOf(register: FrameRegister | undefined, index: number, table: Table | undefined): string {
  const address = register?.address;
  if (register?.record) return words.record(register.record.file, register.record.record);
  return address === undefined ? words.inList(index) : words.address(address, table && entityNumber(table, address));
}

interface MarkedProps {
  readonly views: readonly ValueView[];
  readonly registers: readonly FrameRegister[];
}

/** The values that look right, each with the reason. */
function Marked({ views, registers }: MarkedProps) {
  const rank = ({ likely }: ValueView) => RANK.indexOf(likely?.code ?? '');
  const marked = views.filter(({ likely }) => likely).toSorted((a, b) => rank(a) - rank(b));
  return (
    <div aria-live="polite">
      <h3 id="marked">{words.marked}</h3>
      {marked.length === 0 ? (
        <p class="said">{words.notMarked}</p>
      ) : (
        <ul class="marked" aria-labelledby="marked">
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
  readonly none: boolean;
  readonly elsewhere: readonly { readonly place: number; readonly view: ValueView }[];
  readonly nameAt: (place: number) => string;
  readonly onGo: (place: number) => void;
}

/** Where else the expected value stands. */
function Found({ none, elsewhere, nameAt, onGo }: FoundProps) {
  if (none) return <p class="said">{words.notFound}</p>;
  if (elsewhere.length === 0) return null;
  return (
    <>
      <h3>{words.elsewhere}</h3>
      <ul class="marked">
        {elsewhere.map(({ place, view }) => (
          <li key={`${place}-${view.type}-${view.order}`}>
            <b class="mono">{view.text}</b> {view.type} {view.order}{' '}
            <button type="button" onClick={() => onGo(place)}>
              {words.goTo(nameAt(place))}
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}
