import type { ComponentChildren } from 'preact';
import type { Profile, SerialSettings } from '../../../devices/index.ts';
import { serialFormatName } from '../../../modbus/index.ts';
import { addressOf } from '../../../store/index.ts';
import { deviceWords as words } from '../../parts/device/device-words.ts';

/** What a profile says of its device as a whole. */
export function About({ profile }: { profile: Profile }) {
  const { source, convention, serial, traits, notes } = profile;
  return (
    <>
      <dl class="device-about">
        {source && <Said name={words.from} says={source} />}
        <Said name={words.manual} says={words.conventions[convention]} />
        {serial && <Said name={words.serialLine} says={<Line serial={serial} />} />}
        {traits.length > 0 && <Said name={words.departs} says={traits.map((trait) => words.traits[trait]).join(' ')} />}
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

/** The settings of the line, and what they come to in time. */
const Line = ({ serial }: { serial: SerialSettings }) => (
  <>
    {words.serial(serial)}{' '}
    <a href={addressOf('timing', { baud: String(serial.baud), format: serialFormatName(serial) })}>
      {words.lineTiming}
    </a>
  </>
);

const Said = ({ name, says }: { name: string; says: ComponentChildren }) => (
  <div>
    <dt>{name}</dt>
    <dd>{says}</dd>
  </div>
);
