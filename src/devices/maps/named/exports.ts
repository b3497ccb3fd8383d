import { numberOf, numberText } from '../loose.ts';
import type { Sheet, SheetRow } from '../sheet.ts';

/** A program whose exported table is known by its headers. */
interface Export {
  readonly format: string;
  /** Headers that all are there. */
  readonly headers: readonly string[];
  readonly read: (cell: (header: string) => string) => Readonly<Record<string, string>>;
}

/** Reads the cells that were exported by a program whose words are known, and leaves every other table as it is. */
export function knownExport(sheet: Sheet): Sheet {
  const [first, ...rows] = sheet.rows;
  const headers = first?.cells.map((cell) => cell.trim()) ?? [];
  const known = EXPORTS.find((each) => each.headers.every((header) => headers.includes(header)));
  if (first === undefined || known === undefined) return sheet;
  const read = rows.map(({ cells }) => known.read((header) => cells[headers.indexOf(header)]?.trim() ?? ''));
  const columns = [...new Set(read.flatMap((cells) => Object.keys(cells)))].filter((column) =>
    read.some((cells) => cells[column]),
  );
  return {
    ...sheet,
    kind: 'named',
    format: known.format,
    headed: true,
    rows: [
      { ...first, cells: columns },
      ...rows.map((row, index): SheetRow => ({ ...row, cells: columns.map((column) => read[index]?.[column] ?? '') })),
    ],
  };
}

const ORDERS = new Map([
  ['be', 'ABCD'],
  ['le', 'DCBA'],
  ['sw', 'CDAB'],
  ['sb', 'DCBA'],
]);

const EXPORTS: readonly Export[] = [
  {
    // The tab-separated text of a list of registers of ioBroker.modbus: https://github.com/ioBroker/ioBroker.modbus.
    format: 'iobroker',
    headers: ['_address', 'type', 'len'],
    read: (cell) => {
      const [, type = cell('type'), order = ''] =
        /^(u?int(?:16|32|64)|float|double)(be|le|sw|sb)$/.exec(cell('type')) ?? [];
      const length = numberOf(cell('len'));
      const isText = /^(?:string|rawhex)/.test(type);
      return {
        name: cell('name'),
        address: cell('_address'),
        type,
        'word order': ORDERS.get(order) ?? '',
        'count of registers': isText ? cell('len') : length === undefined ? '' : cell('len'),
        factor: cell('factor'),
        offset: cell('offset'),
        unit: cell('unit'),
        description: [cell('description'), cell('formula')].filter(Boolean).join(' '),
      };
    },
  },
  {
    // The tags of a device of KEPServerEX.
    format: 'kepware',
    headers: ['Tag Name', 'Address', 'Data Type', 'Client Access'],
    read: (cell) => ({
      name: cell('Tag Name'),
      ...arrayOf(cell('Address')),
      type: cell('Data Type').replace(/ Array$/, ''),
      ...linear(cell),
      unit: cell('Eng Units') || cell('Eng. Units'),
      access: cell('Client Access'),
      description: cell('Description'),
    }),
  },
];

/** `400030[4]` is an array of four values, and `400030[2][3]` one of six. */
function arrayOf(address: string): Readonly<Record<string, string>> {
  const [, first = '', rows = '', columns = '1'] = /^([^[]+)\[(\d+)\](?:\[(\d+)\])?$/.exec(address) ?? [];
  return first === '' ? { address } : { address: first, count: String(Number(rows) * Number(columns)) };
}

/** Linear scaling is said by two points. */
function linear(cell: (header: string) => string): Readonly<Record<string, string>> {
  if (!/^linear$/i.test(cell('Scaling'))) return {};
  const [rawLow, rawHigh, low, high] = ['Raw Low', 'Raw High', 'Scaled Low', 'Scaled High'].map((header) =>
    numberOf(cell(header)),
  );
  if (rawLow === undefined || rawHigh === undefined || low === undefined || high === undefined || rawLow === rawHigh)
    return {};
  const factor = ((high - low) / (rawHigh - rawLow)) * (/^(?:1|true)$/i.test(cell('Negate Value')) ? -1 : 1);
  const tidy = (value: number) => numberText(Number(value.toPrecision(12)));
  const offset = factor < 0 === high < low ? low - factor * rawLow : -low - factor * rawLow;
  return { factor: tidy(factor), ...(Math.abs(offset) < 1e-12 ? {} : { offset: tidy(offset) }) };
}
