import { isTextType, type ValueType } from '../../modbus/index.ts';
import { wordsOf } from '../codec.ts';
import { isBitTable, type NamedNumber, type Register } from '../profile.ts';
import { bitsType, type DraftRegister } from './row-register.ts';

/** A register of the profile with the rows it was made of, its own row first. */
export interface JoinedRegister {
  readonly draft: DraftRegister;
  readonly register: Register;
  readonly rows: readonly number[];
}

const keyOf = ({ register, row }: DraftRegister): string =>
  `${register.table} ${register.address} ${row.models.join()}`;

/** Puts rows of single bits together: they become the names of the bits of the register that a row has, or of one of their own. */
export function joinBits(all: readonly DraftRegister[]): readonly JoinedRegister[] {
  const drafts = all.flatMap(bitsBelow);
  const bitRows = new Map<string, DraftRegister[]>();
  const wholes = new Map<string, DraftRegister>();
  for (const draft of drafts) {
    const key = keyOf(draft);
    if (!isBitRow(draft)) {
      // A part of a register has none of its other bits.
      if (draft.register.mask === undefined) wholes.set(key, wholes.get(key) ?? draft);
    } else {
      const rows = bitRows.get(key);
      if (rows) rows.push(draft);
      else bitRows.set(key, [draft]);
    }
  }
  const done = new Set<string>();
  return drafts.flatMap((draft): JoinedRegister[] => {
    const key = keyOf(draft);
    const own = bitRows.get(key);
    if (!isBitRow(draft)) {
      if (!own || wholes.get(key) !== draft) return [{ draft, register: draft.register, rows: linesOf([draft]) }];
      return [{ draft, register: withBits(draft.register, own), rows: linesOf([draft, ...own]) }];
    }
    if (!own || wholes.has(key) || done.has(key)) return [];
    done.add(key);
    return [{ draft, register: ofBits(draft, own), rows: linesOf(own) }];
  });
}

/** A row of one bit, and those below it that name other bits of its register, as rows of their own. */
function bitsBelow(draft: DraftRegister): readonly DraftRegister[] {
  const { register, row } = draft;
  if (!isBitRow(draft)) return [draft];
  return [
    draft,
    ...row.parts.flatMap(({ bit, name }) =>
      bit === undefined ? [] : [{ ...draft, bit, register: { ...register, name }, notices: [], assumed: [] }],
    ),
  ];
}

/** The rows of registers and of their parts, each once. */
function linesOf(drafts: readonly DraftRegister[]): readonly number[] {
  const [first] = drafts;
  if (first && drafts.length === 1 && first.row.parts.length === 0) return [first.row.line];
  return [...new Set(drafts.flatMap(({ row }) => [row.line, ...row.parts.map(({ line }) => line)]))];
}

/** Whether a row is of one bit, and not of a whole register that has a bit for a name. */
const isBitRow = ({ bit, register }: DraftRegister): boolean => bit !== undefined && !isBitTable(register.table);

const withBits = (register: Register, rows: readonly DraftRegister[]): Register => ({
  ...register,
  type: bitsType(register.type) ?? register.type,
  names: [...register.names, ...namesOf(rows)],
});

/** The register of bits whose rows name no register: its name is what they have in common, or its number. */
function ofBits({ row, register }: DraftRegister, rows: readonly DraftRegister[]): Register {
  const single = rows.length === 1;
  const name = single
    ? register.name
    : commonStart(rows.map((one) => one.register.name)) || row.group || printed(row.printed);
  const access = rows.every((one) => one.register.access === register.access) ? register.access : 'rw';
  return {
    ...register,
    name,
    type: wideEnough(register, rows),
    access,
    names: single && register.names.length > 0 ? register.names : namesOf(rows),
    description: single ? register.description : '',
  };
}

/** As wide as the type of the rows, or as the highest bit asks for. */
function wideEnough({ type }: Register, rows: readonly DraftRegister[]): ValueType {
  const highest = rows.reduce((most, { bit = 0 }) => Math.max(most, bit), 0);
  return highest > 31 ? 'bits64' : highest > 15 ? 'bits32' : (bitsType(type) ?? 'bits');
}

/** `40001.0` without its bit. */
const printed = (text: string): string => text.replace(/^(.*?\d)\s*[.:/[( ].*$/, '$1');

const SHORTEST = 4;

function commonStart([first = '', ...others]: readonly string[]): string {
  let length = first.length;
  for (const other of others) while (!other.startsWith(first.slice(0, length))) length--;
  const start = first
    .slice(0, length)
    .replace(/[\s\d:.,([-]+$/, '')
    .replace(/\b(?:bit|b)$/i, '')
    .trim();
  return start.length >= SHORTEST && others.length > 0 && /[\s:.\-_([\d]/.test(first.charAt(start.length)) ? start : '';
}

function namesOf(rows: readonly DraftRegister[]): readonly NamedNumber[] {
  let before = -1;
  return rows.map(({ bit = 0, register }) => {
    // A spreadsheet makes 40001.1 of 40001.10.
    const number = before === 9 && bit === 1 ? 10 : bit;
    before = number;
    return { number, name: register.name };
  });
}

/** Rows whose address is far from those of the rows before and behind, which are close together. */
export function outliers(registers: readonly JoinedRegister[]): readonly number[] {
  return registers.flatMap(({ register, rows }, at) => {
    const [before, after] = [registers[at - 1]?.register, registers[at + 1]?.register];
    if (!before || !after || before.table !== register.table || after.table !== register.table) return [];
    const step = after.address - before.address;
    const outside = register.address < before.address || register.address > after.address;
    return step > 0 && step <= CLOSE && outside ? [rows[0] ?? 0] : [];
  });
}

/** Two registers with one between them are not further apart than this. */
const CLOSE = 8;

/** Rows whose registers take the same addresses: twice the same one, or a part of another. */
export function collisions(registers: readonly JoinedRegister[]): {
  readonly twice: readonly number[];
  readonly overlaps: readonly number[];
} {
  const twice = new Set<number>();
  const overlaps = new Set<number>();
  const sorted = registers
    .map((one) => ({ ...one, end: one.register.address + sizeOf(one.register) }))
    .toSorted((a, b) =>
      a.register.table < b.register.table
        ? -1
        : a.register.table > b.register.table
          ? 1
          : a.register.address - b.register.address,
    );
  let last: (typeof sorted)[number] | undefined;
  for (const one of sorted) {
    const [line = 0] = one.rows;
    if (last && last.register.table === one.register.table && one.register.address < last.end && !areApart(last, one)) {
      const into = last.register.address === one.register.address ? twice : overlaps;
      into.add(last.rows[0] ?? 0);
      into.add(line);
    }
    if (!last || last.register.table !== one.register.table || one.end > last.end) last = one;
  }
  const inOrder = (rows: ReadonlySet<number>) => [...rows].sort((a, b) => a - b);
  return { twice: inOrder(twice), overlaps: inOrder(overlaps) };
}

/** Two of different models, or of different bits of one register. */
const areApart = (one: JoinedRegister, other: JoinedRegister): boolean =>
  differentModels(one, other) || (bitsOf(one.register) & bitsOf(other.register)) === 0;

/** The bits of a register of 16 that its value takes. */
function bitsOf({ type, mask, names }: Register): number {
  if (type === 'bits' && names.length > 0) return names.reduce((bits, { number }) => bits | (1 << number), 0);
  if (type.endsWith('8h')) return 0xff00;
  return type.endsWith('8l') ? 0x00ff : (mask ?? 0xffff) & 0xffff || 0xffff;
}

const differentModels = (one: JoinedRegister, other: JoinedRegister): boolean => {
  const [own, models] = [one.draft.row.models, other.draft.row.models];
  return own.length > 0 && models.length > 0 && !own.some((model) => models.includes(model));
};

const sizeOf = ({ table, type, count }: Register): number =>
  isBitTable(table) || isTextType(type) ? count : count * wordsOf(type);
