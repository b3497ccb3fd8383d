import { dictionary } from '../../modbus/index.ts';
import { type PlcMeaning, plcCodes, plcMeanings } from '../../notation/index.ts';
import { type Convention, type EntityTable, entityTables } from '../profile.ts';
import type { AddressCell } from './address-cell.ts';
import { tableSpokenOf } from './cell-words.ts';
import { type CountedCell, type Counting, countingOf, countings, digitTable, type Place, placeOf } from './counting.ts';
import { type Answers, type DigitMeaning, digitDoubt, tableOfRow, usualTable } from './decisions.ts';
import { exampleText } from './examples.ts';
import type { MapBlock } from './map-blocks.ts';
import type { MapRow } from './map-row.ts';
import { linesOf, type Report } from './report.ts';

/** A row with its table and its address from 0. */
export interface PlacedRow {
  readonly row: MapRow;
  readonly block: MapBlock;
  readonly table: EntityTable;
  readonly address: number;
}

interface BlockRow {
  readonly row: MapRow;
  readonly block: MapBlock;
}

export const CONVENTIONS: Readonly<Record<Counting, Convention>> = {
  zero: 'zero-based',
  one: 'one-based',
  'five-digit': 'five-digit',
  'six-digit': 'six-digit',
  'five-digit-zero': 'zero-based',
};

const countingNamed = (text: string | undefined): Counting | undefined =>
  countings.find((each) => each === text || CONVENTIONS[each] === text?.toLowerCase());

/** Finds the table and the address of every row, asking for what the rows do not say. */
export function placeRows(
  blocks: readonly MapBlock[],
  /** Addresses of ranges that the file names beside its registers. */
  ranges: readonly AddressCell[],
  answers: Answers,
  report: Report,
  file: string,
): { readonly placed: readonly PlacedRow[]; readonly counting: Counting; readonly pair: boolean } {
  const rows = blocks.flatMap((block) => block.read.rows.map((row): BlockRow => ({ row, block })));
  tellOfStyles(blocks, report);
  const digits = decideDigits(rows, answers, report);
  const saidOf = ({ row }: BlockRow) => tableOfRow(row, digits);
  const deviceAt = decideController(rows, answers, report);
  const { counting, strict, pair } = decideCounting(rows, ranges, saidOf, answers, report);
  const start = decideStart(blocks, answers, report);
  const silent: (BlockRow & { readonly address: number })[] = [];
  const placed = rows.flatMap((one): (PlacedRow | { readonly waiting: number })[] => {
    const { row, block } = one;
    const said = saidOf(one);
    const fixed = fixedCounting(block);
    const place = deviceAt(row) ?? placeOf(row.address, fixed ?? counting, said.table, fixed !== undefined || strict);
    const base = baseOf(block, start);
    const address = place.kind === 'place' ? place.address + base : -1;
    if (place.kind !== 'place' || address > LAST || address < 0) {
      report.faults.add(place.kind === 'odd' ? 'not-in-convention' : 'address-outside', linesOf([row, ...row.parts]));
      return [];
    }
    if (place.odd) report.notices.add('odd-number', [row.line]);
    if (place.table && said.table && place.table !== said.table)
      report.notices.add('number-of-other-table', [row.line]);
    if (said.unread) report.notices.add('table-unknown', [row.line]);
    const table = said.table ?? place.table;
    if (table) return [{ row, block, table, address }];
    silent.push({ row, block, address });
    return [{ waiting: silent.length - 1 }];
  });
  const lost = silent.map(({ row }) => row);
  const ofFile = tableSpokenOf(file.replace(/\.\w{1,5}$/, ''));
  const table = usualTable(lost, answers['table'] ?? ofFile);
  const [first] = lost;
  if (answers['table'] === undefined)
    report.ask('table', entityTables, table, lost, exampleText(first, first?.printed ?? '', entityTables));
  return {
    placed: placed.map((one) =>
      'waiting' in one ? { ...(silent[one.waiting] as (typeof silent)[number]), table } : one,
    ),
    counting,
    pair,
  };
}

const LAST = 0xffff;

/** Says where digits are grouped, and asks for the base of digits that are decimal or hexadecimal. */
function tellOfStyles(blocks: readonly MapBlock[], report: Report): void {
  for (const { style, read } of blocks) {
    const textOf = (row: MapRow | undefined) => row?.printed ?? '';
    if (style.grouped)
      report.notices.add('number-grouped', linesOf(read.rows.filter((row) => /[.,]/.test(textOf(row)))));
    if (!style.doubtful) continue;
    const first = read.rows.find((row) => row.address.number > 9) ?? read.rows[0];
    const outcomes = [16, 10].map((base) => String(Number.parseInt(textOf(first), base)));
    report.ask(
      'base',
      ['hexadecimal', 'decimal'],
      'hexadecimal',
      read.rows,
      exampleText(first, textOf(first), outcomes),
    );
  }
}

function decideDigits(rows: readonly BlockRow[], answers: Answers, report: Report): DigitMeaning {
  const plain = rows.map(({ row }) => row);
  const { meaning, asked } = digitDoubt(plain, answers['function-or-digit']);
  if (asked) {
    const concerned = plain.filter((row) => /^[134]$/.test(row.text('table').trim()));
    const digit = concerned[0]?.text('table').trim() ?? '';
    report.ask(
      'function-or-digit',
      ['function', 'digit'],
      meaning,
      concerned,
      exampleText(concerned[0], digit, exampleTables(digit)),
    );
  }
  return meaning;
}

const FUNCTIONS: Readonly<Record<string, string>> = dictionary({
  '1': 'coil',
  '3': 'holding-register',
  '4': 'input-register',
});
const TABLES: Readonly<Record<string, string>> = dictionary({
  '1': 'discrete-input',
  '3': 'input-register',
  '4': 'holding-register',
});
const exampleTables = (digit: string): readonly string[] => [FUNCTIONS[digit] ?? '', TABLES[digit] ?? ''];

/** The number in the name is the address. */
const DIRECT = 'direct';

/**
 * Where the devices are that addresses name, by the family of controllers: of `%MW100` mostly the number itself, of `D100` and the
 * like what the family says that has most of them.
 */
function decideController(
  rows: readonly BlockRow[],
  answers: Answers,
  report: Report,
): (row: MapRow) => (Place & { readonly kind: 'place' }) | { readonly kind: 'outside' } | undefined {
  const named = rows.map(({ row }) => row).filter(({ address }) => address.device !== undefined);
  if (named.length === 0) return () => undefined;
  const meaningsOf = new Map(named.map((row) => [row, plcMeanings(row.address.device ?? '')]));
  const countOf = (plc: string) =>
    named.filter((row) => meaningsOf.get(row)?.some((meaning) => meaning.plc === plc)).length;
  const families = plcCodes
    .map((plc) => ({ plc, count: countOf(plc) }))
    .filter(({ count }) => count > 0)
    .sort((one, other) => other.count - one.count)
    .map(({ plc }) => plc);
  const isDirect = named.every(({ address }) => address.table !== undefined);
  const options = [...(isDirect ? [DIRECT] : []), ...families];
  const answered = options.find((option) => option === answers['plc']);
  const plc = answered ?? options[0] ?? DIRECT;
  const placeIn = (row: MapRow, family: string) => {
    if (family === DIRECT) return undefined;
    const found: PlcMeaning | undefined = meaningsOf.get(row)?.find((meaning) => meaning.plc === family);
    return found
      ? { kind: 'place' as const, address: found.address, table: found.table as EntityTable }
      : { kind: 'outside' as const };
  };
  const [first] = named;
  const outcome = (option: string) => {
    const place = first && (placeIn(first, option) ?? { kind: 'place' as const, address: first.address.number });
    return place?.kind === 'place' ? String(place.address) : '–';
  };
  if (answered === undefined)
    report.ask('plc', options, plc, named, exampleText(first, first?.printed ?? '', options.map(outcome)));
  return (row) => (row.address.device === undefined ? undefined : placeIn(row, plc));
}

/** The counting that a table says itself: our own tables count addresses from 0, whatever their numbers do. */
function fixedCounting({ settings, sheet, printed }: MapBlock): Counting | undefined {
  const named = countingNamed(settings.facts.convention);
  if (named) return printed ? named : 'zero';
  return countingNamed(settings.facts.counting ?? sheet.facts?.counting);
}

/** How the numbers of all tables count that do not say it themselves. */
function decideCounting(
  all: readonly BlockRow[],
  ranges: readonly AddressCell[],
  saidOf: (row: BlockRow) => { readonly table?: EntityTable },
  answers: Answers,
  report: Report,
): { readonly counting: Counting; readonly strict: boolean; readonly pair: boolean } {
  const answered = countingNamed(answers['counting']);
  if (answered) return { counting: answered, strict: true, pair: false };
  const silent = all.filter(({ block }) => fixedCounting(block) === undefined);
  if (silent.length === 0) {
    const [said] = all.flatMap(({ block }) => fixedCounting(block) ?? []);
    return { counting: said ?? 'zero', strict: true, pair: false };
  }
  const cells = silent.map(
    (one): CountedCell => ({ cell: one.row.address, table: saidOf(one).table, number: one.row.number }),
  );
  const choice = countingOf(
    [...cells, ...ranges.map((cell) => ({ cell }))],
    silent.every(({ block }) => block.printed),
  );
  const rows = silent.map(({ row }) => row);
  if (choice.likeNumbers)
    report.notices.add('addresses-like-numbers', linesOf(rows.filter((row) => digitTable(row.address))));
  if (choice.rounded) report.notices.add('assumed', linesOf(rows), { question: 'counting' });
  if (choice.options.length > 0) {
    const [first] = rows;
    const outcomes = choice.options.map((option) => {
      const place = first && placeOf(first.address, option, undefined, false);
      return place?.kind === 'place' ? String(place.address) : '–';
    });
    const text = first?.printed ?? '';
    report.ask('counting', choice.options, choice.counting, rows, exampleText(first, text, outcomes));
  }
  return { counting: choice.counting, strict: false, pair: choice.pair === true };
}

const STARTS = ['0', '40000', '40002', '40070', '50000'];

/** The address at which the models of SunSpec begin, which their description does not say. */
function decideStart(blocks: readonly MapBlock[], answers: Answers, report: Report): number {
  const answer = answers['start'];
  const start = Number(answer ?? 0);
  if (answer !== undefined) return Number.isInteger(start) ? start : 0;
  const rows = blocks.filter(isUnplaced).flatMap(({ read }) => read.rows);
  const number = rows[0]?.address.number ?? 0;
  const outcomes = STARTS.map((option) => String(Number(option) + number));
  report.ask('start', STARTS, '0', rows, exampleText(rows[0], String(number), outcomes));
  return 0;
}

const isUnplaced = ({ sheet }: MapBlock): boolean =>
  sheet.format === 'sunspec' && sheet.facts?.addressBase === undefined;

function baseOf(block: MapBlock, start: number): number {
  if (isUnplaced(block)) return start;
  const base = Number(block.sheet.facts?.addressBase ?? 0);
  return Number.isInteger(base) ? base : 0;
}
