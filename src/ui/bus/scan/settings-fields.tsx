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
