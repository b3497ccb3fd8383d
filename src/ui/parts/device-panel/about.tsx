import type { ComponentChildren } from 'preact';
import type { Profile, SerialSettings } from '../../../devices/index.ts';
import { serialFormatName } from '../../../modbus/index.ts';
import { addressOf } from '../../../store/index.ts';
import { useWords } from '../words.ts';

/** What a profile says of its device as a whole. */
export function About({ profile }: { profile: Profile }) {
  const words = useWords('devices');
  const { source, convention, serial, unit, traits, notes } = profile;
  return (
    <>
      <dl class="device-about">
        {source && <Fact name={words.from} value={source} />}
        <Fact name={words.manual} value={words.conventions[convention]} />
        {serial && <Fact name={words.serialLine} value={<Line serial={serial} />} />}
        {unit !== undefined && <Fact name={words.unit} value={unit} />}
        {traits.length > 0 && (
          <Fact name={words.departs} value={traits.map((trait) => words.traits[trait]).join(' ')} />
        )}
      </dl>
      {notes.length > 0 && (
        <details>
          <summary>{words.odd(notes.length)}</summary>
          <ul class="device-notes">
            {notes.map((note) => (
              <li key={note}>{note}</li>
            ))}
          </ul>
        </details>
      )}
    </>
  );
}

/** The settings of the line, and the way to its timing. */
function Line({ serial }: { serial: SerialSettings }) {
  const words = useWords('devices');
  return (
    <>
      {words.serial(serial)}{' '}
      <a href={addressOf('timing', { baud: String(serial.baud), format: serialFormatName(serial) })}>
        {words.lineTiming}
      </a>
    </>
  );
}

const Fact = ({ name, value }: { name: string; value: ComponentChildren }) => (
  <div>
    <dt>{name}</dt>
    <dd>{value}</dd>
  </div>
);
