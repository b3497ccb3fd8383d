/**
 * No compiler of Studio 5000 can be had, so that its routines are held against rules. What passes is carried out, written again
 * in JavaScript.
 */
export class RockwellFault extends Error {}

/** Whole numbers are `bigint`, whose division leaves the fraction out, as that of DINT does. */
type Value = bigint | string | bigint[];

export interface Routines {
  /** Names of tags, in capitals. */
  readonly tags: readonly string[];
  set(tag: string, value: number | readonly number[]): void;
  /** A number, or the numbers of an array. */
  get(tag: string): number | readonly number[];
  run(routine: string): void;
}

const WORDS = new Set(
  'IF THEN ELSE ELSIF END_IF FOR TO BY DO END_FOR WHILE END_WHILE CASE OF END_CASE AND OR XOR NOT MOD TRUNC JSR COP'.split(
    ' ',
  ),
);
const MOST_NAME = 40;

/** The program of a list of tags and a text of routines; a `RockwellFault` if a rule does not hold. */
export function routinesOf(list: string, text: string): Routines {
  const types = new Map<string, string>();
  for (const line of list.trim().split('\n').slice(1)) {
    const [, name = '', type = ''] = /^TAG,,(\w+),"[^"]*","([A-Z]+(?:\[\d+\])?)","",""$/.exec(line) ?? [];
    if (!/^(?:DINT|BOOL|REAL|STRING)(?:\[\d+\])?$/.test(type)) throw new RockwellFault(`not a tag: ${line}`);
    if (name.length > MOST_NAME || /__|_$/.test(name)) throw new RockwellFault(`not a name: ${name}`);
    if (types.has(name.toUpperCase())) throw new RockwellFault(`a tag twice: ${name}`);
    types.set(name.toUpperCase(), type);
  }
  const parts = text.split(/^\/\/ ---- routine (\w+)\n/m).slice(1);
  const names = parts.filter((_, index) => index % 2 === 0);
  const bodies = parts.filter((_, index) => index % 2 === 1);
  const tags: Record<string, Value> = {};
  for (const [name, type] of types) {
    const size = /\[(\d+)\]/.exec(type)?.[1];
    tags[name] = size === undefined ? 0n : new Array<bigint>(Number(size)).fill(0n);
  }
  const known = (name: string): string => {
    if (!types.has(name.toUpperCase())) throw new RockwellFault(`no tag ${name}`);
    return `tags.${name.toUpperCase()}`;
  };
  const script = bodies.map(
    (body, index) =>
      `${names[index]}() {\n${body
        .split('\n')
        .map((line) => scriptOf(line, known, names))
        .join('\n')
        .replace(/(break;\s*)\} else \{/, '$1default:')}\n},`,
  );
  const whole = (value: unknown, name: string): unknown => {
    if (typeof value !== 'bigint') return typeof value === 'boolean' ? BigInt(value) : value;
    if (BigInt.asIntN(33, value) !== value) throw new RangeError(`${name} := ${value}`);
    return BigInt.asIntN(32, value);
  };
  const at = (array: readonly bigint[], index: bigint): number => {
    if (!(index >= 0n && index < BigInt(array.length))) throw new RangeError(`element ${index} of ${array.length}`);
    return Number(index);
  };
  const cop = (from: bigint[], to: bigint[], many: number): void => {
    if (many > from.length || many > to.length) throw new RangeError(`${many} elements`);
    for (let index = 0; index < many; index++) to[index] = from[index] ?? 0n;
  };
  const routines = new Function(
    'tags',
    'whole',
    'at',
    'cop',
    `const routines = {${script.join('\n')}}; return routines;`,
  )(tags, whole, at, cop);
  return {
    tags: Object.keys(tags),
    set: (tag, value) => {
      if (tags[tag] === undefined) throw new RangeError(`no tag ${tag}`);
      tags[tag] = typeof value === 'number' ? BigInt(value) : value.map(BigInt);
    },
    get: (tag) => {
      const value = tags[tag];
      return Array.isArray(value) ? value.map(Number) : Number(value);
    },
    run: (name) => routines[name](),
  };
}

function scriptOf(full: string, known: (name: string) => string, routines: readonly string[]): string {
  const line = full.replace(/\/\/.*$/, '').trim();
  if (/>>|<<|==|!=|\(\*|\b[A-Z]+#|\bSH[LR]\b|_TO_|\bVAR\b|\bU(?:S|D)?INT\b/.test(line))
    throw new RockwellFault(`Studio 5000 has no such thing: ${line}`);
  const expression = (of: string): string =>
    of
      .replace(/16#([\dA-F]+)/g, (_, digits: string) => `${Number.parseInt(digits, 16)}`)
      .replace(/(?<![\w.])\d+(?![\w.])/g, '$&n')
      .replace(/'[^']*'|\b[A-Za-z]\w*\b(?!')/g, (word) => {
        if (word.startsWith("'")) return word;
        const operator = { AND: '&', OR: '|', XOR: '^', MOD: '%', NOT: '!', TRUNC: 'Math.trunc' }[word];
        if (operator !== undefined) return operator;
        if (WORDS.has(word)) throw new RockwellFault(`${word}: ${line}`);
        return known(word);
      })
      .replace(/<>/g, '!==')
      .replace(/(?<![<>!=])=(?!=)/g, '===');
  const set = (to: string, value: string): string => {
    const [, name = '', index] = /^(\w+)(?:\[(.+)\])?$/.exec(to) ?? [];
    const tag = known(name);
    const target = index === undefined ? tag : `${tag}[at(${tag}, ${expression(index)})]`;
    return `${target} = whole(${expression(value)}, '${name.toUpperCase()}');`;
  };
  const forms: readonly (readonly [RegExp, (one: string, two: string, three: string) => string])[] = [
    [/^$/, () => ''],
    [/^IF (.+) THEN (\w+) := (.+); END_IF;$/, (when, to, value) => `if (${expression(when)}) { ${set(to, value)} }`],
    [/^IF (.+) THEN$/, (when) => `if (${expression(when)}) {`],
    [/^ELSIF (.+) THEN$/, (when) => `} else if (${expression(when)}) {`],
    [/^ELSE$/, () => '} else {'],
    [/^END_(?:IF|FOR|WHILE|CASE);$/, () => '}'],
    [
      /^FOR (\w+) := (.+) TO (.+) BY 1 DO$/,
      (name, from, to) =>
        `for (${known(name)} = ${expression(from)}; ${known(name)} <= ${expression(to)}; ${known(name)}++) {`,
    ],
    [/^WHILE (.+) DO$/, (when) => `while (${expression(when)}) {`],
    [
      /^JSR\((\w+), 0\);$/,
      (name) => {
        if (!routines.includes(name)) throw new RockwellFault(`no routine ${name}`);
        return `routines.${name}();`;
      },
    ],
    [/^COP\((\w+)\[0\], (\w+)\[0\], (\d+)\);$/, (from, to, many) => `cop(${known(from)}, ${known(to)}, ${many});`],
    [/^RET\(\);$/, () => 'return;'],
    [/^CASE (\w+) OF$/, (of) => `switch (${known(of)}) {`],
    [/^(-?\d+): (\w+) := ('.*');$/, (label, to, text) => `case ${label}n: ${set(to, text)} break;`],
    [/^(\w+(?:\[.+?\])?) := (.+);$/, (to, value) => set(to, value)],
  ];
  for (const [form, write] of forms) {
    const [, one = '', two = '', three = ''] = form.exec(line) ?? [];
    if (form.test(line)) return write(one, two, three);
  }
  throw new RockwellFault(`not a statement: ${line}`);
}
