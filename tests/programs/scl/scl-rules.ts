/**
 * No compiler of SCL can be had, so that its texts are held against rules: what TIA Portal refuses. What passes is written again
 * as Structured Text, so that the strict machine can run it.
 */
export class SclFault extends Error {}

const TYPES: Readonly<Record<string, string>> = {
  Byte: 'BYTE',
  Word: 'WORD',
  DWord: 'DWORD',
  DInt: 'DINT',
  Bool: 'BOOL',
  LReal: 'LREAL',
  String: 'STRING',
  Time: 'TIME',
  TON_TIME: 'TON',
};
const KEYWORDS = new Set(
  'IF THEN ELSE ELSIF END_IF FOR TO DO END_FOR WHILE END_WHILE CASE OF END_CASE RETURN AND OR XOR NOT MOD TRUE FALSE IN N PT Q T'.split(
    ' ',
  ),
);
const FUNCTIONS = /^(?:SHL|SHR|FLOOR_LREAL|[A-Z]+_TO_[A-Z]+)$/;
const LITERALS = /\b(?:BYTE|WORD|DWORD)#16#[\dA-F]+\b|\bT#\d+ms\b|'(?:[^$']|\$.)*'/g;

/** The rules for a line of statements. */
function checkStatement(line: string): void {
  if (/>>|<<|==|!=|\/\//.test(line)) throw new SclFault(`an operator that SCL has not: ${line}`);
  const bare = line.replace(LITERALS, ' ').replace(/"[A-Za-z]\w*"(?:\.\w+)?/g, ' ');
  for (const found of bare.matchAll(/(#?)\b([A-Za-z_]\w*)\b(\s*:=)?/g)) {
    const [, mark, name = '', set] = found;
    // The name of a parameter in a call.
    const isParameter =
      set !== undefined && bare.slice(0, found.index).split('(').length > bare.slice(0, found.index).split(')').length;
    if (mark === '#' || isParameter || KEYWORDS.has(name) || FUNCTIONS.test(name)) continue;
    throw new SclFault(`${name} is local and has no #: ${line}`);
  }
  if (/#\d|16#/.test(bare)) throw new SclFault(`a literal without a type: ${line}`);
}

/** The text as Structured Text; a `SclFault` if a rule does not hold. */
export function asStructuredText(text: string): string {
  const arrays = new Map<string, string>();
  const type = (of: string): string => {
    const [, last, item = ''] = /^Array\[0\.\.(\d+)\] of (\w+)$/.exec(of) ?? [];
    const plain = TYPES[item === '' ? of : item];
    if (plain === undefined) throw new SclFault(`no type ${of}`);
    if (item === '') return plain;
    const name = `T_${plain}_${last}`;
    arrays.set(name, `TYPE\n${name} : ARRAY[0..${last}] OF ${plain};\nEND_TYPE`);
    return name;
  };
  const out: string[] = [];
  let place: 'outside' | 'head' | 'section' | 'body' = 'outside';
  let unit = '';
  for (const full of text.split('\n')) {
    const line = full.replace(/\/\/.*$/, '').trim();
    if (line === '') continue;
    const [, kind, name, gives] = /^(FUNCTION|FUNCTION_BLOCK) "(\w+)"(?: : (\w+))?$/.exec(line) ?? [];
    if (place === 'outside') {
      if (kind === undefined || name === undefined) throw new SclFault(`a name of a block stands in quotes: ${line}`);
      out.push(gives === undefined ? `${kind} ${name}` : `${kind} ${name} : ${type(gives)}`);
      unit = kind;
      place = 'head';
    } else if (place === 'head') {
      if (/^(?:\{ S7_Optimized_Access := 'TRUE' \}|VERSION : \d+\.\d+)$/.test(line)) continue;
      if (line === 'BEGIN') place = 'body';
      else if (/^VAR(?:_INPUT|_IN_OUT|_OUTPUT|_TEMP| CONSTANT)?$/.test(line)) {
        if (unit === 'FUNCTION' && (line === 'VAR' || line === 'VAR_OUTPUT'))
          throw new SclFault('a function keeps nothing');
        out.push(line === 'VAR_TEMP' ? 'VAR' : line);
        place = 'section';
      } else throw new SclFault(`BEGIN is missing: ${line}`);
    } else if (place === 'section') {
      if (line === 'END_VAR') {
        out.push(line);
        place = 'head';
        continue;
      }
      const [, variable, of = '', first] = /^([A-Za-z]\w*) : ([^:]+?)(?: := (.+))?;$/.exec(line) ?? [];
      if (variable === undefined) throw new SclFault(`not a declaration: ${line}`);
      if (first?.startsWith('[')) throw new SclFault(`an array has no first values: ${line}`);
      out.push(`${variable} : ${type(of)}${first === undefined ? '' : ` := ${first}`};`);
    } else if (line === `END_${unit}`) {
      out.push(line);
      place = 'outside';
    } else {
      checkStatement(line);
      out.push(
        line
          .replace(/(SH[LR])\(IN := /g, '$1(')
          .replace(/, N := (?:DINT_TO_UINT(?=\())?/g, ', ')
          .replace(/(?<!\w)#(?=[A-Za-z_])/g, '')
          .replace(/"(FC_\w+)"/g, '$1'),
      );
    }
  }
  if (place !== 'outside') throw new SclFault('the end is missing');
  return [...arrays.values(), ...out].join('\n');
}
