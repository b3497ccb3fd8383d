import type { Order } from '../../modbus/index.ts';
import { readOrderName } from '../../notation/index.ts';
import { type EntityTable, entityTables, isBitTable } from '../profile.ts';
import { type Answers, orderOptions, readTypeCodes, typeCodes, usualType } from './decisions.ts';
import { exampleText, scaleExample } from './examples.ts';
import type { MapBlock } from './map-blocks.ts';
import type { MapRow } from './map-row.ts';
import type { PlacedRow } from './place-rows.ts';
import { linesOf, type Report } from './report.ts';
import { type DraftRegister, type RowRules, registerOf } from './row-register.ts';
import { scaleChoice } from './scale.ts';

/** The registers of all rows, asking for what the rows do not say of their values. */
export function draftRows(
  placed: readonly PlacedRow[],
  blocks: readonly MapBlock[],
  answers: Answers,
  report: Report,
): readonly DraftRegister[] {
  const rows = placed.map(({ row }) => row);
  const untyped = placed.filter(({ row, table }) => !isBitTable(table) && row.text('type').trim() === '');
  const type = usualType(
    untyped.map(({ row }) => row),
    answers['type'],
  );
  const codes = decideTypeCodes(rows, answers, report);
  const decimalsScale = decideDecimals(placed, blocks, answers, report);
  const answeredOrder = readOrderName(answers['order'] ?? '');
  const length = Number(answers['text-length']);
  const choices = new Map(
    blocks.map((block) => [
      block,
      // A format with a name has a factor and a divisor of its own.
      scaleChoice(block.read.rows, block.columns, block.sheet.kind === 'named' ? 'multiply' : answers['scale']),
    ]),
  );
  const rulesOf = new Map(
    blocks.map((block): [MapBlock, RowRules] => {
      const said: Order | undefined = readOrderName(block.settings.facts.order ?? block.sheet.facts?.order ?? '');
      return [
        block,
        {
          scale: {
            choice: choices.get(block) ?? { plain: 'multiply', times: 'multiply', asked: new Set() },
            decimalsScale,
            hasScale: hasScale([block]),
          },
          type: type.type,
          order: answeredOrder ?? said ?? 'ABCD',
          orderKnown: answeredOrder !== undefined || said !== undefined,
          codes,
          textLength: length > 0 && Number.isInteger(length) ? length : undefined,
        },
      ];
    }),
  );
  const nextOf = nextAddresses(placed);
  const drafts = placed.map(({ row, block, table, address }) =>
    registerOf(row, { table, address }, rulesOf.get(block) as RowRules, nextOf(table, address)),
  );
  const of = (what: 'type' | 'order' | 'text-length' | 'scale') =>
    drafts.filter(({ assumed }) => assumed.includes(what)).map(({ row }) => row);
  const doubted = [...choices.values()].find(({ asked }) => asked.size > 0);
  const first = doubted?.first;
  const assumed = doubted?.asked.has('plain') ? doubted.plain : (doubted?.times ?? 'multiply');
  report.ask('scale', ['multiply', 'divide'], assumed, of('scale'), scaleExample(first));
  const few = of('type').length < drafts.length * FEW;
  if (few && of('type').length > 0) report.notices.add('type-unknown', linesOf(of('type')));
  if (!few && answers['type'] === undefined)
    report.ask('type', type.options, type.type, of('type'), exampleText(of('type')[0], '0000 0001', type.options));
  const bytes = ['0000 0001', '0001 0000', '0000 0100', '0100 0000'];
  report.ask('order', orderOptions, 'ABCD', of('order'), exampleText(of('order')[0], '1', bytes));
  if (answers['text-length'] === undefined)
    report.ask('text-length', ['4', '8', '16', '20', '32'], '8', of('text-length'));
  return withScaleRegisters(drafts, placed, report);
}

/** Of so few rows without a type nobody is asked. */
const FEW = 0.05;

function decideTypeCodes(rows: readonly MapRow[], answers: Answers, report: Report): RowRules['codes'] {
  const found = typeCodes(rows);
  const answer = answers['type-codes'];
  const answered = readTypeCodes(answer ?? '');
  if (answer === undefined) {
    const each = Array.from(found.keys(), (code) => `${code}=u16`);
    const concerned = rows.filter((row) => found.has(row.text('type').trim()));
    const example = Array.from(found, ([code, row]) => `${code}: ${row.text('name')}`).join(' | ');
    report.ask('type-codes', each, each.join('; '), concerned, example);
  }
  return new Map(Array.from(found.keys(), (code) => [code, answered.get(code) ?? { type: 'u16' as const, factor: 1 }]));
}

/** Whether decimals scale whole numbers. */
function decideDecimals(
  placed: readonly PlacedRow[],
  blocks: readonly MapBlock[],
  answers: Answers,
  report: Report,
): boolean {
  const answer = answers['decimals'];
  if (answer === 'scale' || answer === 'shown') return answer === 'scale';
  // A unit such as `0.1V` has the scale, and the decimals are what is left of it.
  const isInUnit = placed.some(({ row }) => row.read.unit(row.text('unit')).scale !== undefined);
  if (hasScale(blocks) || isInUnit) return false;
  const concerned = placed
    .filter(({ row, table }) => !isBitTable(table) && isWhole(row) && /^[1-9]$/.test(row.text('decimals')))
    .map(({ row }) => row);
  const power = 10 ** Number(concerned[0]?.text('decimals') ?? 0);
  report.ask(
    'decimals',
    ['scale', 'shown'],
    'scale',
    concerned,
    exampleText(concerned[0], '490', [String(490 / power), '490']),
  );
  return concerned.length > 0;
}

const hasScale = (blocks: readonly MapBlock[]): boolean =>
  blocks.some(({ columns }) =>
    columns.some(({ meaning }) => meaning === 'factor' || meaning === 'divisor' || meaning === 'exponent'),
  );

const isWhole = (row: MapRow): boolean => !/float|real|double|f32|f64|single/i.test(row.text('type'));

/** The next address of a table behind one that is in use. */
function nextAddresses(placed: readonly PlacedRow[]): (table: EntityTable, address: number) => number | undefined {
  const next = new Map<string, number>();
  for (const table of entityTables) {
    const used = [...new Set(placed.filter((one) => one.table === table).map(({ address }) => address))].sort(
      (a, b) => a - b,
    );
    used.forEach((address, at) => {
      const following = used[at + 1];
      if (following !== undefined) next.set(`${table} ${address}`, following);
    });
  }
  return (table, address) => next.get(`${table} ${address}`);
}

/** Finds the registers with the power of ten by their name, or by their address from the beginning of the same table. */
function withScaleRegisters(
  drafts: readonly DraftRegister[],
  placed: readonly PlacedRow[],
  report: Report,
): readonly DraftRegister[] {
  if (!drafts.some(({ scaleRegister }) => scaleRegister !== undefined)) return drafts;
  const found = new Map<string, number>();
  const keyOf = (block: MapBlock | undefined, table: EntityTable, text: string) =>
    `${block?.sheet.name ?? ''} ${table} ${text}`;
  placed.forEach(({ row, block, table, address }) => {
    for (const text of [row.printed, row.text('name'), ...row.texts('other-name')])
      if (text !== '' && !found.has(keyOf(block, table, text))) found.set(keyOf(block, table, text), address);
  });
  return drafts.map((draft, place) => {
    const { scaleRegister, register } = draft;
    if (scaleRegister === undefined) return draft;
    const address = found.get(keyOf(placed[place]?.block, register.table, scaleRegister));
    if (address !== undefined) return { ...draft, register: { ...register, scaleRegister: { address } } };
    report.notices.add('scale-register-unknown', [draft.row.line]);
    return draft;
  });
}
