import { numberOf } from '../loose.ts';
import type { Sheet, SheetRow } from '../sheet.ts';
import { type NamedRow, type NamedTable, namedSheets, readHolding, readInput } from './named-format.ts';

const FORMAT = 'modpoll';

const TABLES: ReadonlyMap<string, string> = new Map([
  ['coil', 'coil'],
  ['discrete_input', 'discrete-input'],
  ['input_register', readInput],
  ['holding_register', readHolding],
]);

/** The orders of bytes in a register, and of registers in a value. */
const ORDERS: ReadonlyMap<string, string> = new Map([
  ['BE_BE', 'ABCD'],
  ['BE_LE', 'CDAB'],
  ['LE_BE', 'BADC'],
  ['LE_LE', 'DCBA'],
]);

/** What is asked in one request; the references below it are in its reply. */
interface Poller {
  readonly table: string;
  readonly start: number;
  readonly order: string;
}

interface DeviceRows {
  readonly name: string;
  readonly unit: string;
  readonly rows: { readonly row: NamedRow; readonly line: number }[];
}

/**
 * The configuration of modpoll, whose rows are devices, what is asked of them, and references: https://github.com/gavinying/modpoll.
 * `undefined` for any other table. A device has a table of its own. In the older form a poll names the device itself.
 */
export function readModpoll({ rows }: Sheet): readonly Sheet[] | undefined {
  const own = rows.filter(({ cells: [first = ''] }) => !first.trim().startsWith('#'));
  if (own.length < 2 || !own.every(({ cells: [first = ''] }) => /^(?:device|poll|ref)$/i.test(first.trim())))
    return undefined;
  const devices: DeviceRows[] = [];
  let poller: Poller | undefined;
  const open = (name: string, unit: string) => {
    const last = devices.at(-1);
    if (last?.name !== name || last.unit !== unit) devices.push({ name, unit, rows: [] });
  };
  for (const { cells, line } of own) {
    const [kind = '', ...rest] = cells.map((cell) => cell.trim());
    if (/^device$/i.test(kind)) open(rest[0] ?? '', rest[1] ?? '');
    else if (/^poll$/i.test(kind)) {
      if (!TABLES.has(rest[0]?.toLowerCase() ?? '')) open(rest[0] ?? '', rest[1] ?? '');
      poller = pollerOf(rest);
    } else if (poller) devices.at(-1)?.rows.push({ row: rowOf(rest, poller), line });
  }
  const filled = devices.filter(({ rows }) => rows.length > 0);
  if (filled.length === 0) return undefined;
  return namedSheets(FORMAT, filled.map(tableOf)).map((sheet, at) => ({
    ...sheet,
    rows: sheet.rows.map((row, index): SheetRow => ({ ...row, line: filled[at]?.rows[index - 1]?.line ?? row.line })),
  }));
}

const tableOf = ({ name, unit, rows }: DeviceRows): NamedTable => ({
  ...(name === '' ? {} : { name }),
  // Addresses are those of the frames, whatever they look like.
  facts: { counting: 'zero', ...(name === '' ? {} : { device: name }), ...(unit === '' ? {} : { unit }) },
  rows: rows.map(({ row }) => row),
});

function pollerOf(cells: readonly string[]): Poller | undefined {
  const at = cells.findIndex((cell) => TABLES.has(cell.toLowerCase()));
  const start = numberOf(cells[at === 0 ? 1 : 2]);
  const table = TABLES.get(cells[at]?.toLowerCase() ?? '');
  const order = cells.map((cell) => ORDERS.get(cell.toUpperCase())).find((each) => each !== undefined);
  return table === undefined || start === undefined ? undefined : { table, start, order: order ?? 'ABCD' };
}

/** A name, perhaps a blank cell, then address, type, access, unit and factor. */
function rowOf([name, ...rest]: readonly string[], { table, start, order }: Poller): NamedRow {
  const [address = '', dtype = '', access = '', unit = '', scale = ''] = rest[0] === '' ? rest.slice(1) : rest;
  const type = dtype.toLowerCase();
  const own = { name, table, access: access.toLowerCase() || 'r', unit, factor: scale };
  const from = numberOf(address);
  const [, bits] = /^bool(8|16)?$/.exec(type) ?? [];
  if (table === 'coil' || table === 'discrete-input') {
    // Here an address counts bytes of eight, from where the request begins.
    const first = from === undefined ? address : start + 8 * (from - start);
    return { ...own, address: first, type: 'bool', count: Number(bits ?? 8) };
  }
  const [, characters] = /^string(\d*)$/.exec(type) ?? [];
  // In a single register only the bytes can be swapped, and a text has its own order.
  const single = order === 'BADC' || order === 'DCBA' ? 'BADC' : '';
  return {
    ...own,
    address,
    order: characters !== undefined ? '' : /16$|^$|^bool/.test(type) ? single : order,
    type: type.startsWith('bool') ? 'uint16' : characters === undefined ? type || 'uint16' : 'string',
    registers: characters === undefined ? '' : Math.ceil(Number(characters || 2) / 2),
  };
}
