import { coilByteCount, type Profile } from '../../devices/index.ts';
import { fieldValue } from '../../modbus/index.ts';
import { evaluation } from '../state.ts';
import { deviceWords as words } from './language.ts';
import { takeByteCount } from './take-up.ts';

/** What a profile says of its device as a whole. */
export function About({ profile }: { profile: Profile }) {
  const { source, convention, serial, traits, notes } = profile;
  return (
    <>
      <dl class="device-about">
        {source && <Said name={words.from} says={source} />}
        <Said name={words.manual} says={words.conventions[convention]} />
        {serial && <Said name={words.serialLine} says={words.serial(serial)} />}
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

const Said = ({ name, says }: { name: string; says: string }) => (
  <div>
    <dt>{name}</dt>
    <dd>{says}</dd>
  </div>
);

/** The byte count that the device wants of the frame at hand, where the frame has another. */
export function byteCountWanted(profile: Profile | undefined): number | undefined {
  const reading = evaluation.value.frame?.reading;
  if (!profile || reading?.functionCode !== 0x0f || reading.direction !== 'request') return undefined;
  const quantity = fieldValue(reading, 'quantity');
  const standard = typeof quantity === 'number' ? coilByteCount(quantity, []) : undefined;
  if (typeof quantity !== 'number' || reading.derived['byteCount'] !== standard) return undefined;
  const wanted = coilByteCount(quantity, profile.traits);
  return wanted === standard ? undefined : wanted;
}

/** Offers the byte count that the device wants. */
export const ByteCountOffer = ({ wanted }: { wanted: number | undefined }) =>
  wanted === undefined ? null : (
    <p>
      <button type="button" onClick={() => takeByteCount(wanted)}>
        {words.useByteCount(wanted)}
      </button>
    </p>
  );
