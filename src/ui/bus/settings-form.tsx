import type { ComponentChild } from 'preact';
import type { LinkSettings, TransactionRules } from '../../bus/index.ts';
import { wholeNumber } from '../../notation/index.ts';
import { linkLimits, ruleLimits } from '../../workbench/index.ts';
import { Choice, optionsOf } from '../kit/choice.tsx';
import { NumberEntry } from '../kit/number-entry.tsx';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';

const USUAL_SPEEDS = [1200, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200, 230_400, 460_800, 921_600];

/** How a port is opened. A change holds from the next opening on. */
export function SettingsForm() {
  const text = useWords('bus').settings;
  const settings = bus.settings.value;
  const set = (change: Partial<LinkSettings>) => {
    bus.settings.value = { ...bus.settings.value, ...change };
  };
  const number = (name: 'baud' | 'bufferSize', label: string, wrong: string, usual?: readonly number[]) => {
    const [least, most] = linkLimits[name];
    return (
      <NumberEntry
        label={label}
        value={settings[name]}
        read={wholeNumber(least, most)}
        wrong={wrong}
        usual={usual?.map(String)}
        onValue={(value) => set({ [name]: value })}
      />
    );
  };
  const choice = <K extends 'dataBits' | 'parity' | 'stopBits' | 'flowControl'>(
    name: K,
    label: string,
    options: readonly { readonly value: LinkSettings[K]; readonly name: string }[],
  ) => (
    <Choice
      id={`bus-${name}`}
      label={label}
      value={settings[name]}
      options={options}
      onChoose={(value) => set({ [name]: value })}
    />
  );
  const bits = <T extends number>(...counts: readonly T[]) => counts.map((value) => ({ value, name: String(value) }));
  // A setting without a field is an error of types.
  const fields: Readonly<Record<keyof LinkSettings, ComponentChild>> = {
    baud: number('baud', text.baud, text.baudWrong, USUAL_SPEEDS),
    dataBits: choice('dataBits', text.dataBits, bits(7, 8)),
    parity: choice('parity', text.parity, optionsOf(text.parities)),
    stopBits: choice('stopBits', text.stopBits, bits(1, 2)),
    flowControl: choice('flowControl', text.flowControl, optionsOf(text.flows)),
    bufferSize: number('bufferSize', text.bufferSize, text.bufferWrong),
  };
  return (
    <fieldset class="settings field-grid">
      <legend>{text.heading}</legend>
      {Object.values(fields)}
      {bus.connected.value && <p class="said">{text.later}</p>}
    </fieldset>
  );
}

/** How transactions are carried out. A change holds from the next request on. */
export function RulesForm() {
  const text = useWords('bus').rules;
  const rules = bus.rules.value;
  const set = (change: Partial<TransactionRules>) => bus.setRules({ ...bus.rules.value, ...change });
  const number = (name: 'timeout' | 'retries' | 'turnaround') => {
    const [least, most] = ruleLimits[name];
    return (
      <NumberEntry
        label={text[name]}
        value={rules[name]}
        read={wholeNumber(least, most)}
        wrong={text.wrong(least, most)}
        onValue={(value) => set({ [name]: value })}
      />
    );
  };
  return (
    <fieldset class="settings field-grid">
      <legend>{text.heading}</legend>
      {number('timeout')}
      {number('retries')}
      {number('turnaround')}
      <Choice
        id="bus-echo"
        label={text.echo}
        value={rules.echo}
        options={optionsOf(text.echoes)}
        onChoose={(echo) => set({ echo })}
      />
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
