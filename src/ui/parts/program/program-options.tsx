import { useId } from 'preact/hooks';
import { usualProgram as usual } from '../../../codegen/index.ts';
import type { Transport } from '../../../modbus/index.ts';
import {
  LEAST_TIMEOUT,
  MOST_PORT,
  MOST_TIMEOUT,
  type ProgramSettings,
  readOwnNames,
} from '../../../workbench/index.ts';
import { Choice, optionsOf } from '../../kit/choice.tsx';
import { Field } from '../../kit/field.tsx';
import { Fold } from '../../kit/fold.tsx';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { TextField } from '../../kit/text-field.tsx';
import { device } from '../device/naming.ts';
import { useWords } from '../words.ts';
import { programs } from './program-store.ts';

/** A whole number from `least` to `most`; `undefined` if a text is not one. */
const wholeNumber = (least: number, most: number) => (typed: string) => {
  const value = /^\s*\d{1,7}\s*$/.test(typed) ? Number(typed) : Number.NaN;
  return value >= least && value <= most ? value : undefined;
};

/** How programs are written: kept for every program that comes. */
export function ProgramOptions({ transport }: { readonly transport: Transport }) {
  const words = useWords('program');
  return (
    <Fold summary={words.options} class="program-options">
      {() => <Options transport={transport} />}
    </Fold>
  );
}

function Options({ transport }: { readonly transport: Transport }) {
  const words = useWords('program');
  const id = useId();
  const settings = programs.settings.value;
  const { faults } = readOwnNames(settings.names);
  const profile = device.value;
  return (
    <>
      <div class="field-grid">
        {transport === 'rtu' && (
          <Choice
            id={`${id}-crc`}
            label={words.crc}
            value={settings.crc}
            options={optionsOf(words.crcWays)}
            onChoose={(crc) => programs.set({ crc })}
          />
        )}
        <NumberEntry
          label={words.timeout}
          value={settings.timeout}
          read={wholeNumber(LEAST_TIMEOUT, MOST_TIMEOUT)}
          wrong={words.timeoutWrong(LEAST_TIMEOUT, MOST_TIMEOUT)}
          onValue={(timeout) => programs.set({ timeout })}
        />
        {transport === 'tcp' ? (
          <>
            <TextField
              id={`${id}-host`}
              label={words.host}
              text={settings.host}
              hint={words.blank(usual.server.host)}
              onText={(host) => programs.set({ host })}
            />
            <NumberEntry
              label={words.tcpPort}
              value={settings.tcpPort}
              read={wholeNumber(1, MOST_PORT)}
              wrong={words.tcpPortWrong(MOST_PORT)}
              onValue={(tcpPort) => programs.set({ tcpPort })}
            />
          </>
        ) : (
          <TextField
            id={`${id}-port`}
            label={words.port}
            text={settings.port}
            hint={words.blank(usual.line.port)}
            onText={(port) => programs.set({ port })}
          />
        )}
        <TextField
          id={`${id}-name`}
          label={words.name}
          text={programs.name.value}
          hint={words.nameHint}
          onText={(name) => {
            programs.name.value = name;
          }}
        />
        <Field
          id={`${id}-names`}
          label={words.names}
          hint={words.namesHint}
          error={faults.length > 0 ? words.namesWrong(faults) : ''}
        >
          <textarea
            id={`${id}-names`}
            rows={2}
            class="mono"
            spellcheck={false}
            value={settings.names}
            aria-invalid={faults.length > 0}
            aria-describedby={`${id}-names-said`}
            onInput={({ currentTarget }) => programs.set({ names: currentTarget.value })}
          />
        </Field>
      </div>
      <Flag of="comments" label={words.comments} />
      {profile && <Flag of="units" label={words.units(profile.name)} />}
      {transport !== 'tcp' && <Flag of="echo" label={words.echo} />}
    </>
  );
}

type FlagName = { [K in keyof ProgramSettings]: ProgramSettings[K] extends boolean ? K : never }[keyof ProgramSettings];

const Flag = ({ of, label }: { readonly of: FlagName; readonly label: string }) => (
  <label class="program-flag">
    <input
      type="checkbox"
      checked={programs.settings.value[of]}
      onChange={({ currentTarget }) => programs.set({ [of]: currentTarget.checked })}
    />{' '}
    {label}
  </label>
);
