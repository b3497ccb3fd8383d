import { firstAddress, type Problem, type Reading } from '../modbus/index.ts';
import { wordsOf } from './codec.ts';
import { linesAt } from './named.ts';
import { type EntityTable, isBitTable, type Profile } from './profile.ts';
import { ownByteCount } from './request.ts';
import { countsValues, isOwnOn, type Trait } from './traits.ts';

/** More elements than any request has, of which no more is worked out. */
const MOST = 250;

/** Whether a frame of a device is right by a trait, though it breaks a rule of the specification. */
type Excuse = (profile: Profile, reading: Reading, problem: Problem) => boolean;

const excuses: Readonly<Record<Trait, Excuse>> = {
  'one-address-each-value': (profile, reading, problem) => {
    const table = tableOf(reading);
    if (!isOfCount(problem) || table === undefined || isBitTable(table)) return false;
    const list = problem.span.name === 'writeByteCount' ? 'writeRegisters' : 'registers';
    const first = firstAddress(reading, list);
    // What the specification expects is two bytes for each element.
    return first !== undefined && bytesByValue(profile, table, first, problem.expected / 2) === problem.got;
  },
  'any-value-is-on': (profile, _, problem) => problem.code === 'coil-value-illegal' && isOwnOn(profile, problem.got),
  'byte-count-plus-one': (profile, reading, problem) =>
    isOfCount(problem) && ownByteCount(profile, reading) === problem.got,
};

/** The trait of a device by which a frame is right, though it breaks a rule of the specification. */
export const departure = (profile: Profile, reading: Reading, problem: Problem): Trait | undefined =>
  profile.traits.find((trait) => excuses[trait](profile, reading, problem));

const isOfCount = (problem: Problem) =>
  problem.code === 'count-contradicts-quantity' || problem.code === 'count-not-as-requested';

function tableOf({ description }: Reading): EntityTable | undefined {
  const table = description?.table;
  return table === 'file-record' ? undefined : table;
}

/** The bytes of a number of elements, if the device counts each value as one element; else `undefined`. */
function bytesByValue(profile: Profile, table: EntityTable, first: number, quantity: number): number | undefined {
  if (!countsValues(profile) || quantity > MOST) return undefined;
  let words = 0;
  for (let at = first; at < first + quantity; at++) {
    const lines = linesAt(profile, table, at).filter(({ begins }) => begins);
    words += Math.max(1, ...lines.map(({ register: { type } }) => wordsOf(type)));
  }
  return 2 * words;
}
