import { isTextType, type Order, type ValueType } from '../../modbus/index.ts';
import { type NamedType, orderNames, plainName, typeNames } from './value-names.ts';

/** What the name of a type says, in a table of registers. */
export interface TypeReading extends NamedType {
  /** Values that follow each other (`uint16[3]`), or the registers of a text (`STRING[8]`, `text[4]`). */
  readonly count?: number;
  /** The bit that is meant: `bool (bit 4)`. */
  readonly bit?: number;
  /** The name says no width (`INT`, `unsigned`, `float`): where the length is known, it decides. */
  readonly loose?: true;
}

type Family = 'unsigned' | 'signed' | 'float' | 'bcd' | 'bits';
type Widths = Readonly<Partial<Record<number, ValueType>>>;

/** The types of a family by their width in bits. */
const FAMILIES: Readonly<Record<Family, Widths>> = {
  unsigned: { 8: 'u8l', 16: 'u16', 24: 'u24', 32: 'u32', 48: 'u48', 64: 'u64' },
  signed: { 8: 'i8l', 16: 'i16', 24: 'i24', 32: 'i32', 48: 'i48', 64: 'i64' },
  float: { 16: 'f16', 32: 'f32', 64: 'f64' },
  bcd: { 16: 'bcd16', 32: 'bcd32', 64: 'bcd64' },
  bits: { 16: 'bits', 32: 'bits32', 64: 'bits64' },
};

/** Names of a family of types that say no width, and the one that is meant without a length. */
const LOOSE: ReadonlyMap<string, Family> = new Map(
  Object.entries({
    unsigned:
      'uint unsigned unsignedint unsignedinteger hex hexadecimal dec decimal enum enumeration enumerated ganzzahl',
    signed: 'int signed integer signedint signedinteger entier entero intero geheel',
    float:
      'float real floatingpoint ieee754 ieee flt fp gleitkomma fliesskomma fließkomma flottant reel réel reale flotante',
    bcd: 'bcd',
    bits: 'bits bitfield binary bitmap bitmask flags bitstring',
  } satisfies Record<Family, string>).flatMap(([family, names]) =>
    names.split(' ').map((name) => [name, family as Family] as const),
  ),
);

/** What a word of a name says. A width is said by a number, too. */
interface Part {
  readonly family?: 'whole' | Exclude<Family, 'unsigned' | 'signed'>;
  readonly sign?: 'unsigned' | 'signed';
  readonly width?: number;
}

const PARTS: ReadonlyMap<string, Part> = new Map(
  (
    [
      [{ sign: 'unsigned' }, 'u ui unsigned uns unsig nosign'],
      [{ sign: 'signed' }, 's i si signed sig'],
      [{ family: 'whole', sign: 'signed' }, 'int integer integers'],
      [{ family: 'whole' }, 'number num dec decimal hex'],
      [{ family: 'whole', sign: 'unsigned' }, 'uint usint enum enumeration acc accumulator counter'],
      [{ family: 'whole', sign: 'signed' }, 'sint'],
      [{ family: 'whole', width: 16 }, 'word words'],
      [{ family: 'whole', width: 32 }, 'dword doubleword'],
      [{ family: 'whole', width: 64 }, 'qword lword quadword'],
      [{ family: 'whole', sign: 'signed', width: 16 }, 'short'],
      [{ family: 'whole', sign: 'signed', width: 32 }, 'long'],
      [{ family: 'whole', sign: 'signed', width: 64 }, 'longlong llong'],
      [{ family: 'float' }, 'f fp float floating floatingpoint point real flt ieee754 ieee'],
      [{ family: 'float', width: 32 }, 'single'],
      [{ family: 'float', width: 64 }, 'double lreal'],
      [{ family: 'bcd' }, 'bcd'],
      [{ family: 'bits' }, 'bitfield bitmap bitmask flags bitstring'],
      [{}, 'bit bits value values format type data register registers 754 nan modbus'],
    ] satisfies readonly (readonly [Part, string])[]
  ).flatMap(([part, words]) => words.split(' ').map((word) => [word, part] as const)),
);

/** Orders as the ends of names have them: `uint32le`, `U_DWORD_R`, `int32s`, `float32sw`. */
const ORDER_ENDS: ReadonlyMap<string, Order> = new Map<string, Order>([
  ['be', 'ABCD'],
  ['le', 'DCBA'],
  ['sw', 'CDAB'],
  // Of ioBroker, whose `sw` swaps words and whose `sb` turns all four bytes round.
  ['sb', 'DCBA'],
  ['ws', 'CDAB'],
  ['bs', 'BADC'],
  ['r', 'CDAB'],
  ['s', 'CDAB'],
  ['swap', 'CDAB'],
]);

const WIDTHS = [8, 16, 24, 32, 48, 64];
/** Longer texts are not names of types. */
const LONGEST = 60;

/** What a length in registers makes of a name that says no width. */
const widened = (family: Family, registers: number): ValueType | undefined => FAMILIES[family][16 * registers];

/**
 * Reads the name of a type as tables and programs write it: `uint16`, `16-bit unsigned integer`, `U_DWORD_R`, `FLOAT32 (CDAB)`,
 * `STRING[8]`. `registers` is the length that the table gives, which decides what `INT` or `float` is. `undefined` if the
 * text is not the name of a type.
 */
export function readTypeName(text: string, registers?: number): TypeReading | undefined {
  const written = text.normalize('NFKC').trim();
  if (written === '' || written.length > LONGEST) return undefined;
  const array = /^array\s*\[\s*(\d+)\s*\.\.\s*(\d+)\s*\]\s*of\s+(.+)$/i.exec(written);
  if (array) {
    return severalOf(readTypeName(array[3] ?? ''), Number(array[2]) - Number(array[1]) + 1);
  }
  const [, of = '', words = ''] = /^(.*?)[\s,;(–-]+(\d)\s*(?:words?|reg(?:ister)?s?\.?)\)?$/i.exec(written) ?? [];
  if (of !== '') return readTypeName(of, Number(words));
  const [, times = '', repeated = ''] = /^(\d{1,3})\s*[x×*]\s*(\p{L}.*)$/iu.exec(written) ?? [];
  if (times !== '') return severalOf(readTypeName(repeated), Number(times));
  const inBrackets = /[[(]/.test(written) ? withRoom(written) : undefined;
  return (
    inBrackets ?? namedWhole(written, registers) ?? withRoom(written) ?? withBit(written) ?? byParts(written, registers)
  );
}

const severalOf = (type: TypeReading | undefined, count: number): TypeReading | undefined =>
  type && count > 0 ? { ...type, count } : undefined;

/** Reads the name of an order of bytes, in any case and with any separators: `Word Swap`, `CD AB`, `GHEFCDAB`. */
export const readOrderName = (text: string): Order | undefined => orderNames.get(plainName(text.normalize('NFKC')));

function namedWhole(written: string, registers: number | undefined): TypeReading | undefined {
  const name = plainName(written);
  const family = LOOSE.get(name);
  const named = typeNames.get(name);
  if (family === undefined) return named;
  const type = (registers !== undefined && widened(family, registers)) || named?.type || firstOf(family);
  return { type, loose: true };
}

const firstOf = (family: Family): ValueType => (family === 'float' ? 'f32' : (FAMILIES[family][16] as ValueType));

/** `STRING[8]` and `char 20` have characters, `text[4]` registers, `uint16[3]` three values. */
function withRoom(written: string): TypeReading | undefined {
  const [, name = '', digits] =
    /^(.*?[\p{L}\d])\s*(?:[[({<*x\s]\s*)(\d{1,3})\s*(?:bytes?|chars?|characters?)?\s*[\])}>]?$/iu.exec(written) ??
    /^(str|string|char|ascii|utf8|text)(\d{1,3})$/i.exec(written) ??
    [];
  const named = typeNames.get(plainName(name));
  const count = Number(digits);
  if (named === undefined || !(count > 0)) return undefined;
  if (!isTextType(named.type)) {
    const isWidth = LOOSE.has(plainName(name)) && WIDTHS.includes(count);
    return !isWidth && /[[(]|x\s*\d+$/i.test(written.slice(name.length)) ? { ...named, count } : undefined;
  }
  return { ...named, count: plainName(name) === 'text' ? count : Math.ceil(count / 2) };
}

function withBit(written: string): TypeReading | undefined {
  const [, name = '', bit] = /^(.*?)[\s,;:([.]*\bbit\s*#?(\d{1,2})[\])]?$/i.exec(written) ?? [];
  if (bit === undefined) return undefined;
  const named = name.trim() === '' ? { type: 'bits' as const } : typeNames.get(plainName(name));
  return named && { ...named, bit: Number(bit) };
}

/** Reads a name by its words: `32-bit float, word swapped`, `INT16U`, `float32sw`, `swapped float`. */
function byParts(written: string, registers: number | undefined): TypeReading | undefined {
  const words = (
    written
      .replace(/\dS$/, '$&igned')
      .toLowerCase()
      .match(/\d+|\p{L}+/gu) ?? []
  ).flatMap(apart);
  const whole = ofWords(words, registers);
  if (whole) return whole;
  for (let at = 1; at < words.length; at++) {
    const [first, last] = [words.slice(0, at), words.slice(at)];
    const behind = orderOf(last.join(''));
    const type = behind && (namedWhole(first.join(''), registers) ?? ofWords(first, registers));
    if (type) return { ...type, order: behind };
    const before = orderNames.get(first.join(''));
    const rest = before && (namedWhole(last.join(''), registers) ?? ofWords(last, registers));
    if (rest) return { ...rest, order: before };
  }
  return undefined;
}

/** `doublebe` as two words. */
function apart(word: string): readonly string[] {
  const [, name = '', end = ''] = /^(.+)(be|le|sw|sb)$/.exec(word) ?? [];
  return PARTS.get(name)?.family ? [name, end] : [word];
}

/** The type that words say together, if all of them speak of a type. */
function ofWords(words: readonly string[], registers: number | undefined): TypeReading | undefined {
  let said: Part = {};
  for (const [at, word] of words.entries()) {
    const part = isOrderEnd(words, at, said) ? undefined : partOf(word, said);
    if (part === undefined) return undefined;
    said = { ...said, ...part };
  }
  const type = typeOfParts(said, registers);
  return type && { type, ...(said.width === undefined && { loose: true as const }) };
}

function partOf(word: string, { sign, width }: Part): Part | undefined {
  if (/^\d/.test(word)) return WIDTHS.includes(Number(word)) ? { width: Number(word) } : PARTS.get(word);
  const part = PARTS.get(word);
  // `unsigned int` keeps its sign, and `16 bit word` its width.
  const keeps = sign !== undefined && part?.family !== undefined;
  return part && { ...part, ...(keeps && { sign }), ...(width && { width }) };
}

/** Whether a last letter is an order and not a sign: `int32s` is swapped, `int16s` and `INT32S` are signed. */
const isOrderEnd = (words: readonly string[], at: number, { family, width }: Part): boolean =>
  at > 0 &&
  at === words.length - 1 &&
  ORDER_ENDS.has(words[at] ?? '') &&
  (words[at] !== 's' || (width !== undefined && width > 16)) &&
  (family !== undefined || width !== undefined);

const orderOf = (name: string): Order | undefined => ORDER_ENDS.get(name) ?? orderNames.get(name);

function typeOfParts({ family, sign, width }: Part, registers: number | undefined): ValueType | undefined {
  const bits = width ?? (registers === undefined ? undefined : 16 * registers);
  if (family === undefined && (sign === undefined || bits === undefined)) return undefined;
  const of: Family = family === undefined || family === 'whole' ? (sign ?? 'unsigned') : family;
  return bits === undefined ? firstOf(of) : FAMILIES[of][bits];
}
