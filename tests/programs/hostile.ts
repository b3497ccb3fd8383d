import type { ProgramOptions } from '../../src/codegen/index.ts';
import type { FrameInput } from '../../src/modbus/index.ts';

/** Keywords of the languages, by what each says of itself; not out of what the targets know of them. */
const KEYWORDS = `
auto break case char const continue default do double else enum extern float for goto if inline int long register restrict return
short signed sizeof static struct switch typedef union unsigned void volatile while _Bool _Complex asm
alignas alignof and and_eq bitand bitor bool catch char16_t class compl constexpr const_cast decltype delete dynamic_cast explicit
export false friend mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast
static_assert static_cast template this thread_local throw true try typeid typename using virtual wchar_t xor xor_eq
abstract as base byte checked decimal delegate event fixed foreach implicit in interface internal is lock null object out override params
readonly ref sbyte sealed stackalloc string uint ulong unchecked unsafe ushort async await dynamic get set value var when where yield
assert boolean extends final finally implements import instanceof native package strictfp super synchronized throws transient record
permits chan defer fallthrough func go map range select type append cap close complex copy imag iota len make nil panic print println
real recover rune error crate dyn fn impl let loop match mod move mut pub self Self trait unsized use become box macro
typeof priv abstract gen union None False True def del elif except from global lambda nonlocal pass raise with exec bytes id list
dict str int arguments debugger eval function undefined NaN Infinity Buffer process require module exports console
Array BY BOOL BYTE CONSTANT DINT DWORD ELSIF END_FOR END_IF EXIT INT LEN LIMIT MOD MUX OF REAL REPEAT SHR STEP STRING THEN TIME TO
TON UINT UNTIL VAR VAR_INPUT WORD setup Serial Stream String HIGH LOW OUTPUT min max bit errno stdin main EOF NULL assert
`
  .trim()
  .split(/\s+/)
  .filter((name, index, all) => all.indexOf(name) === index);

const request: FrameInput = {
  transport: 'rtu',
  direction: 'request',
  unitId: 17,
  functionCode: 23,
  fields: { readStartAddress: 3, readQuantity: 6, writeStartAddress: 14, writeRegisters: [255, 7] },
};

/** Names in a program that a user may replace, in the styles of all targets. */
const REPLACED = [
  'unit',
  'read start address',
  'read quantity',
  'write start address',
  'crc',
  'frame',
  'length',
] as const;
const styles: readonly ((words: readonly string[]) => string)[] = [
  (words) => words.join('_'),
  (words) => words.map((word, at) => (at === 0 ? word : word.charAt(0).toUpperCase() + word.slice(1))).join(''),
];

/** What is wrong with a name in other ways: letters of all kinds, ends of texts and comments, too long, nothing, one twice. */
const OTHERS = [
  'x'.repeat(300),
  `${'x'.repeat(300)}y`,
  'Größe',
  '水位',
  '名',
  '1st',
  '2',
  '',
  '_',
  '__',
  'a b',
  'a-b',
  'a_b',
  'A B',
  'ab',
  'aB',
  '*/ end',
  '"quoted"',
  "'''",
  '"""',
  '\\',
  'line\nend',
  '$x $(y)',
  '`back`',
  '\u2028',
  '\u202e',
  '??/',
  '#define x',
];

/** Programs whose names are all keywords and other names that no language takes, some in each. */
export const namedPrograms: readonly { readonly request: FrameInput; readonly options: ProgramOptions }[] = Array.from(
  { length: Math.ceil((KEYWORDS.length + OTHERS.length) / REPLACED.length) },
  (_, at) => {
    const names = [...OTHERS, ...KEYWORDS].slice(at * REPLACED.length, (at + 1) * REPLACED.length);
    const options: ProgramOptions = {
      name: names[0] ?? '',
      names: Object.fromEntries(
        names.flatMap((name, index) => styles.map((style) => [style((REPLACED[index] ?? '').split(' ')), name])),
      ),
    };
    return { request, options };
  },
);
