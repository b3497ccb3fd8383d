import {
  accesses,
  addressesOf,
  byteOrders,
  cellsOf,
  entityTables,
  type Profile,
  placeOfRegister,
  plainRegister,
  type Register,
  readCells,
  type TableFault,
  valueTypes,
  type WrittenColumn,
} from '../../devices/index.ts';
import { LAST_ADDRESS } from '../../modbus/index.ts';

/** Cells of which one of a few is chosen; the others are typed. */
const choices: Readonly<Partial<Record<WrittenColumn, readonly string[]>>> = {
  table: entityTables,
  type: valueTypes,
  order: byteOrders,
  access: accesses,
};

/** What a cell may be, if that is one of a few. */
export const cellChoices = (column: WrittenColumn): readonly string[] | undefined => choices[column];

/** The text with which the editing of a cell begins. */
export const cellText = (register: Register, column: WrittenColumn): string => cellsOf(register)[column];

/** What another text in a cell makes of a register. */
export type CellEdit =
  | { readonly kind: 'register'; readonly register: Register }
  | { readonly kind: 'faults'; readonly faults: readonly TableFault[] };

/** A register of a device with another text in one of its cells, read by the rules of an imported row. */
export function withCell(profile: Profile, register: Register, column: WrittenColumn, text: string): CellEdit {
  const cells = { ...cellsOf(register), [column]: text };
  const reading = readCells(cells, profile);
  // Another table may have neither the type nor the access of this one: it gets those that are usual there.
  const follows = new Set<TableFault['code']>(['type-not-for-table', 'table-read-only']);
  const again =
    column === 'table' && reading.kind === 'faults' && reading.faults.every(({ code }) => follows.has(code))
      ? readCells({ ...cells, type: '', access: '' }, profile)
      : reading;
  if (again.kind === 'faults') return again;
  const { table, address } = again.register;
  const place = placeOfRegister(again.register);
  const isThere = (each: Register) =>
    each.address === address && each.table === table && placeOfRegister(each) === place;
  const first = profile.registers.findIndex((each) => each !== register && isThere(each));
  return first < 0
    ? again
    : { kind: 'faults', faults: [{ code: 'name-twice', name: again.register.name, first: first + 1 }] };
}

/** A device with another register in the place of one. */
export const withRegister = (profile: Profile, at: number, register: Register): Profile => ({
  ...profile,
  registers: profile.registers.with(at, register),
});

export const withoutRegister = (profile: Profile, at: number): Profile => ({
  ...profile,
  registers: profile.registers.toSpliced(at, 1),
});

/** A device with one register more, behind all that it has in the table of its last one. */
export function withNewRegister(profile: Profile, name: string): Profile {
  const { table } = profile.registers.at(-1) ?? { table: 'holding-register' as const };
  const ends = profile.registers
    .filter((register) => register.table === table)
    .map((register) => register.address + addressesOf(register, profile));
  const address = Math.min(
    LAST_ADDRESS,
    ends.reduce((last, end) => Math.max(last, end), 0),
  );
  const bare: Register = { ...plainRegister, name, table, address };
  const usual = readCells({ name, table, address: String(address) }, profile);
  return { ...profile, registers: [...profile.registers, usual.kind === 'register' ? usual.register : bare] };
}
