import {
  formatsFor,
  type ScanNumber,
  type ScanSettings,
  scanLimits,
  scanMost,
  scannedTables,
  scanSpeeds,
} from '../../../workbench/index.ts';
import { NumberField } from '../index.ts';
import { scanWords as words } from './scan-words.ts';

interface FieldsProps {
  readonly settings: ScanSettings;
  readonly onChange: (change: Partial<ScanSettings>) => void;
}

/** What is asked of the kind of scan that is chosen. */
export function Fields({ settings, onChange }: FieldsProps) {
  const number = (label: string, name: ScanNumber) => {
    const [least, most] = scanLimits[name];
    return (
      <NumberField
        key={name}
        label={label}
        value={settings[name]}
        least={least}
        most={most}
        wrong={words.wrong(least, most)}
        onChange={(value) => onChange({ [name]: value })}
      />
    );
  };
  const { what } = settings;
  return (
    <>
      <div class="settings">
        {what === 'units'
          ? [number(words.first, 'firstUnit'), number(words.last, 'lastUnit')]
          : number(words.unit, 'unit')}
        {what === 'addresses' && (
          <>
            <div class="control">
              <label for="scan-table">{words.table}</label>
              <select
                id="scan-table"
                value={settings.table}
                onChange={({ currentTarget: { value } }) => {
                  const table = scannedTables.find((one) => one === value);
                  if (table) onChange({ table });
                }}
              >
                {scannedTables.map((table) => (
                  <option key={table} value={table}>
                    {words.tables[table]}
                  </option>
                ))}
              </select>
            </div>
            {number(words.from, 'first')}
            {number(words.to, 'last')}
            {number(words.most, scanMost(settings))}
            {number(words.least, 'least')}
          </>
        )}
        {number(words.timeout, 'timeout')}
        <div class="control">
          <label for="scan-transport">{words.transport}</label>
          <select
            id="scan-transport"
            value={settings.transport}
            onChange={({ currentTarget: { value } }) => onChange({ transport: value === 'ascii' ? 'ascii' : 'rtu' })}
          >
            {(['rtu', 'ascii'] as const).map((transport) => (
              <option key={transport} value={transport}>
                {words.transports[transport]}
              </option>
            ))}
          </select>
        </div>
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
  const toggled = <T,>(all: readonly T[], one: T): readonly T[] =>
    all.includes(one) ? all.filter((other) => other !== one) : [...all, one];
  return (
    <details open={settings.speeds.length > 0 || settings.formats.length > 0}>
      <summary>{words.otherLines}</summary>
      <p class="said">{words.lines}</p>
      <fieldset>
        <legend>{words.speeds}</legend>
        <div class="checks">
          {scanSpeeds.map((speed) => (
            <label key={speed}>
              <input
                type="checkbox"
                checked={settings.speeds.includes(speed)}
                onChange={() => onChange({ speeds: toggled(settings.speeds, speed) })}
              />{' '}
              {speed}
            </label>
          ))}
        </div>
      </fieldset>
      <fieldset>
        <legend>{words.formats}</legend>
        <div class="checks">
          {formatsFor(settings.transport).map((format) => (
            <label key={format}>
              <input
                type="checkbox"
                checked={settings.formats.includes(format)}
                onChange={() => onChange({ formats: toggled(settings.formats, format) })}
              />{' '}
              {format}
            </label>
          ))}
        </div>
      </fieldset>
    </details>
  );
}
