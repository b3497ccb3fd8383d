import { wholeNumber } from '../../../notation/index.ts';
import {
  formatsFor,
  type ScanNumber,
  type ScanSettings,
  scanLimits,
  scanMost,
  scannedTables,
  scanSpeeds,
} from '../../../workbench/index.ts';
import { Choice, optionsOf } from '../../kit/choice.tsx';
import { NumberEntry } from '../../kit/number-entry.tsx';
import { useWords } from '../../parts/words.ts';

interface FieldsProps {
  readonly settings: ScanSettings;
  readonly onChange: (change: Partial<ScanSettings>) => void;
}

/** The settings of the kind of scan that is chosen. */
export function Fields({ settings, onChange }: FieldsProps) {
  const words = useWords('scan');
  const number = (label: string, name: ScanNumber) => {
    const [least, most] = scanLimits[name];
    return (
      <NumberEntry
        key={name}
        label={label}
        value={settings[name]}
        read={wholeNumber(least, most)}
        wrong={words.wrong(least, most)}
        onValue={(value) => onChange({ [name]: value })}
      />
    );
  };
  const { what } = settings;
  return (
    <>
      <div class="settings field-grid">
        {what === 'units'
          ? [number(words.first, 'firstUnit'), number(words.last, 'lastUnit')]
          : number(words.unit, 'unit')}
        {what === 'addresses' && (
          <>
            <Choice
              id="scan-table"
              label={words.table}
              value={settings.table}
              options={scannedTables.map((value) => ({ value, name: words.tables[value] }))}
              onChoose={(table) => onChange({ table })}
            />
            {number(words.from, 'first')}
            {number(words.to, 'last')}
            {number(words.most, scanMost(settings))}
            {number(words.least, 'least')}
          </>
        )}
        {number(words.timeout, 'timeout')}
        <Choice
          id="scan-transport"
          label={words.transport}
          value={settings.transport}
          options={optionsOf(words.transports)}
          onChoose={(transport) => onChange({ transport })}
        />
      </div>
      <p class="said">{words.timeoutHint}</p>
      {what === 'addresses' && (
        <p class="said">
          {words.addressHint} {words.leastHint}
        </p>
      )}
      {what === 'units' && <Lines settings={settings} onChange={onChange} />}
    </>
  );
}

/** Speeds and formats beside that of the line. */
function Lines({ settings, onChange }: FieldsProps) {
  const words = useWords('scan');
  const toggled = <T,>(all: readonly T[], one: T): readonly T[] =>
    all.includes(one) ? all.filter((other) => other !== one) : [...all, one];
  const checks = <T extends string | number>(
    all: readonly T[],
    chosen: readonly T[],
    take: (chosen: readonly T[]) => void,
  ) => (
    <div class="checks in-row">
      {all.map((one) => (
        <label key={one}>
          <input type="checkbox" checked={chosen.includes(one)} onChange={() => take(toggled(chosen, one))} /> {one}
        </label>
      ))}
    </div>
  );
  return (
    <details open={settings.speeds.length > 0 || settings.formats.length > 0}>
      <summary>{words.otherLines}</summary>
      <p class="said">{words.lines}</p>
      <fieldset>
        <legend>{words.speeds}</legend>
        {checks(scanSpeeds, settings.speeds, (speeds) => onChange({ speeds }))}
      </fieldset>
      <fieldset>
        <legend>{words.formats}</legend>
        {checks(formatsFor(settings.transport), settings.formats, (formats) => onChange({ formats }))}
      </fieldset>
    </details>
  );
}
