import { accessOf, fieldByName, hexDigits, type Reading } from '../../modbus/index.ts';
import { plainWords } from '../../notation/index.ts';
import type { FrameNames } from './device-names.ts';

const EXCEPTION = 0x80;

/**
 * What a program may call a frame, as words of lowercase letters and digits, so that frames that do different things do not
 * get one name: `write p0683 30 hz` with a device, else `write 683 4096`.
 */
export function frameName(reading: Reading, names?: FrameNames): readonly string[] {
  const { functionCode = 0, direction, fields } = reading;
  if (functionCode >= EXCEPTION)
    return ['exception', code(functionCode - EXCEPTION), ...numbers(fields['exceptionCode'])];
  const access = accessOf(reading);
  const verb =
    reading.description?.table === undefined
      ? ['function', code(functionCode)]
      : [access === 'reads' ? 'read' : 'write'];
  if (direction === 'response') return ['reply', ...verb, ...detail(reading, names)];
  return [...verb, ...detail(reading, names)];
}

const code = (value: number) => hexDigits(value, 2).toLowerCase();

const numbers = (value: unknown) => (typeof value === 'number' ? [String(value)] : []);

/** The address or its name, and the value or how many. */
function detail(reading: Reading, names: FrameNames | undefined): readonly string[] {
  return Object.entries(reading.fields).flatMap(([name, value]) => {
    const named = words(names?.short(name) ?? '');
    const kind = fieldByName(reading, name)?.kind;
    if (named.length > 0) return named;
    if (kind === 'address' || kind === 'quantity' || kind === 'number') return numbers(value);
    return typeof value === 'boolean' ? [value ? 'on' : 'off'] : [];
  });
}

/** `30.0 Hz` as `30`, `hz`. Letters that programs do not take in names are left out. */
const words = (text: string) =>
  text
    .replace(/\.0+\b/g, '')
    .toLowerCase()
    .match(/[a-z\d]+/g) ?? [];

/**
 * What a program calls frames that are copied together, each by the name that a person gave it, or else by what it does: no
 * name twice, whatever a language makes of capitals and of the ends of words.
 */
export function programNames(
  frames: readonly { readonly name: string; readonly reading: Reading }[],
): readonly (readonly string[])[] {
  const taken = new Set<string>();
  return frames.map(({ name, reading }) => {
    const wanted = givenName(name) ?? frameName(reading);
    let got = wanted;
    for (let count = 2; taken.has(got.join('')); count++) got = [...wanted, String(count)];
    taken.add(got.join(''));
    return got;
  });
}

/** A name as words that programs take; `undefined` if it has no such letters. One word alone may be a word of the language. */
function givenName(name: string): readonly string[] | undefined {
  const found = plainWords(name).split(' ').filter(Boolean);
  if (found.length === 0) return undefined;
  return found.length === 1 || /^\d/.test(found[0] ?? '') ? ['frame', ...found] : found;
}
