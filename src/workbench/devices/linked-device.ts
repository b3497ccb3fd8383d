import { type Profile, readDevice, writeDevice } from '../../devices/index.ts';
import { crc16, hexDigits } from '../../modbus/index.ts';
import { writeQuery } from '../frame/query.ts';

/** A device as a link holds it. */
export interface LinkedDevice {
  /** The id that the link names. */
  readonly id: string;
  readonly text: string;
}

/** A longer text of a device, in characters as the link has them, makes links that many programs cut. */
const LONGEST = 8000;
/** The shortest text of a register, in characters: `[0,"a",0]`. */
const SHORTEST_ROW = 9;

/** A person's own device for a link; `too-large` if it has too many registers. */
export function linkedDevice(profile: Profile, version?: number): LinkedDevice | 'too-large' {
  // The text of 20,000 registers would take a quarter of a second.
  if (profile.registers.length * SHORTEST_ROW > LONGEST) return 'too-large';
  const whole = writeDevice(profile, version);
  const text = fits(whole) ? whole : writeDevice(withoutDescriptions(profile), version);
  return fits(text) ? { id: idOf(profile, text), text } : 'too-large';
}

const fits = (text: string): boolean => writeQuery([['', text]]).length <= LONGEST;

const withoutDescriptions = (profile: Profile): Profile => ({
  ...profile,
  registers: profile.registers.map((register) => ({ ...register, description: '' })),
});

/** Another person may have another device of the same id: what it holds makes it unique. */
const idOf = ({ id }: Profile, text: string): string =>
  `${id}${MARK}${hexDigits(crc16(Uint8Array.from(text, (each) => each.charCodeAt(0))), 4).toLowerCase()}`;

const MARK = '~';

/** Whether an id in a link means a device of this browser; a link that is older has the id of an older text. */
export function isMeant(profile: Profile, id: string | undefined): boolean {
  if (profile.id === id) return true;
  if (!id?.startsWith(`${profile.id}${MARK}`)) return false;
  return [undefined, 1].some((version) => {
    const linked = linkedDevice(profile, version);
    return linked !== 'too-large' && linked.id === id;
  });
}

/** The device in a link; `undefined` if its text cannot be read. */
export const deviceOfLink = ({ id, text }: LinkedDevice): Profile | undefined => readDevice(text, id);
