import { Component, type ComponentChild } from 'preact';
import type { LinkSettings, TransactionRules } from '../../bus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { linkLimits, ruleLimits } from '../../workbench/index.ts';
import { Choice as ChoiceField, optionsOf } from '../kit/choice.tsx';
import { NumberEntry, taking } from '../kit/number-entry.tsx';
import { bus } from './bus.ts';
import { busWords as words } from './bus-words.ts';

const USUAL_SPEEDS = [1200, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200, 230_400, 460_800, 921_600];

/** How a port is opened. A change holds from the next opening on. */
export function SettingsForm({ settings, open }: { readonly settings: LinkSettings; readonly open: boolean }) {
  const text = words.settings;
  const set = (change: Partial<LinkSettings>) => {
    bus.settings.value = { ...bus.settings.value, ...change };
  };
  // A setting without a field is an error of types.
  const fields: Readonly<Record<keyof LinkSettings, ComponentChild>> = {
    baud: (
      <NumberField
        label={text.baud}
        value={settings.baud}
        least={linkLimits.baud[0]}
        most={linkLimits.baud[1]}
        wrong={text.baudWrong}
        usual={USUAL_SPEEDS}
        onChange={(baud) => set({ baud })}
      />
    ),
    dataBits: (
      <Choice
        label={text.dataBits}
        value={settings.dataBits}
        of={{ 7: '7', 8: '8' }}
        onChange={(bits) => set({ dataBits: bits === '7' ? 7 : 8 })}
      />
    ),
    parity: (
      <Choice label={text.parity} value={settings.parity} of={text.parities} onChange={(parity) => set({ parity })} />
    ),
    stopBits: (
      <Choice
        label={text.stopBits}
        value={settings.stopBits}
        of={{ 1: '1', 2: '2' }}
        onChange={(bits) => set({ stopBits: bits === '2' ? 2 : 1 })}
      />
    ),
    flowControl: (
      <Choice
        label={text.flowControl}
        value={settings.flowControl}
        of={text.flows}
        onChange={(flowControl) => set({ flowControl })}
      />
    ),
    bufferSize: (
      <NumberField
        label={text.bufferSize}
        value={settings.bufferSize}
        least={linkLimits.bufferSize[0]}
        most={linkLimits.bufferSize[1]}
        wrong={text.bufferWrong}
        onChange={(bufferSize) => set({ bufferSize })}
      />
    ),
  };
  return (
    <fieldset class="settings">
      <legend>{text.heading}</legend>
      {Object.values(fields)}
      {open && <p class="said">{text.later}</p>}
    </fieldset>
  );
}

/** How transactions are carried out. A change holds from the next request on. */
export function RulesForm({ rules }: { readonly rules: TransactionRules }) {
  const text = words.rules;
  const set = (change: Partial<TransactionRules>) => bus.setRules({ ...bus.state.rules, ...change });
  const number = (label: string, name: 'timeout' | 'retries' | 'turnaround') => {
    const [least, most] = ruleLimits[name];
    return (
      <NumberField
        label={label}
        value={rules[name]}
        least={least}
        most={most}
        wrong={text.wrong(least, most)}
        onChange={(value) => set({ [name]: value })}
      />
    );
  };
  return (
    <fieldset class="settings">
      <legend>{text.heading}</legend>
      {number(text.timeout, 'timeout')}
      {number(text.retries, 'retries')}
      {number(text.turnaround, 'turnaround')}
      <Choice label={text.echo} value={rules.echo} of={text.echoes} onChange={(echo) => set({ echo })} />
      <div class="control wide">
        <label>
          <input
            type="checkbox"
            aria-describedby="bus-quiet-hint"
            checked={rules.quiet}
            onChange={({ currentTarget }) => set({ quiet: currentTarget.checked })}
          />{' '}
          {text.quiet}
        </label>
        <p id="bus-quiet-hint" class="said">
          {text.quietHint(rules.timeout)}
        </p>
      </div>
    </fieldset>
  );
}

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly value: string | number;
  readonly of: Readonly<Record<T, string>>;
  readonly onChange: (value: T) => void;
}

function Choice<T extends string>({ label, value, of, onChange }: ChoiceProps<T>) {
  return (
    <ChoiceField
      id={`bus-${label.replaceAll(' ', '-')}`}
      label={label}
      value={String(value) as T}
      options={optionsOf(of)}
      onChoose={onChange}
    />
  );
}

interface NumberProps {
  readonly label: string;
  readonly value: number;
  readonly least: number;
  readonly most: number;
  /** What is said of anything else. */
  readonly wrong: string;
  readonly usual?: readonly number[];
  readonly onChange: (value: number) => void;
}

let fields = 0;

/** A whole number, decimal or hexadecimal, that is taken while it is typed. */
export class NumberField extends Component<NumberProps> {
  private readonly id = `bus-number-${fields++}`;

  private readonly read = (text: string): number | undefined => {
    const { least, most } = this.props;
    const value = readNumber(text);
    return value !== undefined && Number.isInteger(value) && value >= least && value <= most ? value : undefined;
  };

  render() {
    const { label, value, wrong, usual, onChange } = this.props;
    return (
      <NumberEntry
        id={this.id}
        label={label}
        value={String(value)}
        take={taking(this.read, wrong, onChange)}
        list={usual?.map(String)}
      />
    );
  }
}
