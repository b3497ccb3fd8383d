import { firstAddress, type Problem, type Reading } from '../modbus/index.ts';
import { wordsOf } from './codec.ts';
import { linesAt } from './named.ts';
import { type EntityTable, isBitTable, type Profile, type Trait } from './profile.ts';
import { ownByteCount } from './request.ts';

/** More elements than any request has, of which no more is worked out. */
const MOST = 250;

/** The trait of a device by which a frame is right, though it breaks a rule of the specification. */
export function departure(profile: Profile, reading: Reading, problem: Problem): Trait | undefined {
  const table = reading.description?.table;
  const { traits } = profile;
  switch (problem.code) {
    case 'coil-value-illegal':
      return traits.includes('any-value-is-on') && problem.got >>> 8 !== 0 ? 'any-value-is-on' : undefined;
    case 'count-contradicts-quantity':
    case 'count-not-as-requested': {
      if (table === undefined || table === 'file-record') return undefined;
      const { got, expected } = problem;
      if (isBitTable(table)) {
        return ownByteCount(profile, reading) === got ? 'byte-count-plus-one' : undefined;
      }
      const list = problem.span.name === 'writeByteCount' ? 'writeRegisters' : 'registers';
      const first = firstAddress(reading, list);
      // What the specification expects is two bytes for each element.
      return first !== undefined && bytesByValue(profile, table, first, expected / 2) === got
        ? 'one-address-each-value'
        : undefined;
    }
    default:
      return undefined;
  }
}

/** The bytes of a number of elements, if the device counts each value as one element; else `undefined`. */
function bytesByValue(profile: Profile, table: EntityTable, first: number, quantity: number): number | undefined {
  if (!profile.traits.includes('one-address-each-value') || quantity > MOST) return undefined;
  let words = 0;
  for (let at = first; at < first + quantity; at++) {
    const lines = linesAt(profile, table, at).filter(({ begins }) => begins);
    words += Math.max(1, ...lines.map(({ register: { type } }) => wordsOf(type)));
  }
  return 2 * words;
}
