import { Component, type ComponentChildren } from 'preact';
import type { LinkSettings, TransactionRules } from '../../bus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { bus } from './bus.ts';
import { busWords as words } from './language.ts';

const USUAL_SPEEDS = [1200, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200, 230_400, 460_800, 921_600];

/** How a port is opened. A change holds from the next opening on. */
export function SettingsForm({ settings, open }: { readonly settings: LinkSettings; readonly open: boolean }) {
  const text = words.settings;
  const set = (change: Partial<LinkSettings>) => bus.setSettings({ ...bus.state.settings, ...change });
  return (
    <fieldset class="settings">
      <legend>{text.heading}</legend>
      <NumberField
        label={text.baud}
        value={settings.baud}
        least={1}
        most={4_000_000}
        wrong={text.baudWrong}
        usual={USUAL_SPEEDS}
        onChange={(baud) => set({ baud })}
      />
      <Choice
        label={text.dataBits}
        value={settings.dataBits}
        of={{ 7: '7', 8: '8' }}
        onChange={(bits) => set({ dataBits: bits === '7' ? 7 : 8 })}
      />
      <Choice label={text.parity} value={settings.parity} of={text.parities} onChange={(parity) => set({ parity })} />
      <Choice
        label={text.stopBits}
        value={settings.stopBits}
        of={{ 1: '1', 2: '2' }}
        onChange={(bits) => set({ stopBits: bits === '2' ? 2 : 1 })}
      />
      <Choice
        label={text.flowControl}
        value={settings.flowControl}
        of={text.flows}
        onChange={(flowControl) => set({ flowControl })}
      />
      <NumberField
        label={text.bufferSize}
        value={settings.bufferSize}
        least={1}
        most={16_777_216}
        wrong={text.bufferWrong}
        onChange={(bufferSize) => set({ bufferSize })}
      />
      {open && <p class="said">{text.later}</p>}
    </fieldset>
  );
}

/** How transactions are carried out. A change holds from the next request on. */
export function RulesForm({ rules }: { readonly rules: TransactionRules }) {
  const text = words.rules;
  const set = (change: Partial<TransactionRules>) => bus.setRules({ ...bus.state.rules, ...change });
  const number = (label: string, name: 'timeout' | 'retries' | 'turnaround', least: number, most: number) => (
    <NumberField
      label={label}
      value={rules[name]}
      least={least}
      most={most}
      wrong={text.wrong(least, most)}
      onChange={(value) => set({ [name]: value })}
    />
  );
  return (
    <fieldset class="settings">
      <legend>{text.heading}</legend>
      {number(text.timeout, 'timeout', 1, 60_000)}
      {number(text.retries, 'retries', 0, 10)}
      {number(text.turnaround, 'turnaround', 0, 10_000)}
      <Choice label={text.echo} value={rules.echo} of={text.echoes} onChange={(echo) => set({ echo })} />
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
    <Labelled label={label}>
      {(id) => (
        <select id={id} value={String(value)} onChange={({ currentTarget }) => onChange(currentTarget.value as T)}>
          {Object.entries<string>(of).map(([name, said]) => (
            <option key={name} value={name}>
              {said}
            </option>
          ))}
        </select>
      )}
    </Labelled>
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

/** A number as typed: while it cannot be read its text stays, and the value before it holds. */
export class NumberField extends Component<NumberProps, { readonly text: string | undefined }> {
  override state = { text: undefined as string | undefined };

  private readonly take = (text: string) => {
    const value = readNumber(text);
    const { least, most, onChange } = this.props;
    this.setState({ text });
    if (value !== undefined && Number.isInteger(value) && value >= least && value <= most) onChange(value);
  };

  render() {
    const { label, value, wrong, usual } = this.props;
    const { text } = this.state;
    const isWrong = text !== undefined && readNumber(text) !== value;
    return (
      <Labelled label={label} wrong={isWrong ? wrong : undefined}>
        {(id) => (
          <>
            <input
              id={id}
              class="mono"
              inputMode="text"
              autocomplete="off"
              value={text ?? String(value)}
              list={usual && `${id}-usual`}
              aria-invalid={isWrong}
              aria-describedby={`${id}-said`}
              onInput={({ currentTarget }) => this.take(currentTarget.value)}
              onBlur={() => !isWrong && this.setState({ text: undefined })}
            />
            {usual && (
              <datalist id={`${id}-usual`}>
                {usual.map((one) => (
                  <option key={one} value={one} />
                ))}
              </datalist>
            )}
          </>
        )}
      </Labelled>
    );
  }
}

interface LabelledProps {
  readonly label: string;
  readonly wrong?: string | undefined;
  readonly children: (id: string) => ComponentChildren;
}

function Labelled({ label, wrong, children }: LabelledProps) {
  const id = `bus-${label.toLowerCase().replaceAll(/[^a-z]+/g, '-')}`;
  return (
    <div class="control" data-invalid={wrong ? '' : undefined}>
      <label for={id}>{label}</label>
      {children(id)}
      <p class="said" id={`${id}-said`}>
        {wrong && <span class="error">{wrong}</span>}
      </p>
    </div>
  );
}
