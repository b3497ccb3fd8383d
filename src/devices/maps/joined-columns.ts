import type { Block } from './header-rows.ts';
import { readPairs } from './names-cell.ts';
import { plainHeader } from './plain-header.ts';

/**
 * Writes into one cell what several columns, or a header and its cells, only say together: names of values (`0=Off`) and of bits, and
 * the access of columns called Read and Write.
 */
export const withJoinedColumns = (block: Block): Block =>
  withAccess(withFlags(withBits(withValueRows(withStates(block)))));

const OFF = /^(?:false|off|0|low|aus|falsch)$/i;
const ON = /^(?:true|on|1|high|ein|wahr)$/i;

/** Two columns `False` and `True` name the values 0 and 1: their cells become such names. */
function withStates(block: Block): Block {
  const [off, on] = [OFF, ON].map((word) => block.headers.findIndex((header) => word.test(header)));
  if (off === undefined || on === undefined || off < 0 || on < 0) return block;
  const named = (cell: string, at: number) =>
    at === off && cell.trim() !== '' ? `0=${cell}` : at === on && cell.trim() !== '' ? `1=${cell}` : cell;
  return { ...block, rows: block.rows.map((row) => ({ ...row, cells: row.cells.map(named) })) };
}

/** Headers of columns with the numbers of values whose names stand in the column behind. */
const VALUE =
  /^(?:values?|code|key|raw|state|enum|enum value|option|data|wert|werte|schluessel|valeurs?|valor|valore|waarde|wartosc|值|数值|取值)$/;
const KEY = /^(?:0x[\da-f]{1,8}|[-−]?\d{1,10})$/i;

/**
 * A column of numbers and one of their names behind it, of which the first pair stands in the row of the register and the others in
 * rows below, which are blank elsewhere or repeat the row above: `0`, `Off` become `0=Off`.
 */
function withValueRows(block: Block): Block {
  const at = block.headers.findIndex((header) => VALUE.test(plainHeader(header)));
  if (at < 0 || at + 1 >= block.headers.length) return block;
  const isPair = (cells: readonly string[]) => KEY.test(textAt(cells, at)) && /\p{L}/u.test(textAt(cells, at + 1));
  const others = (cells: readonly string[]) =>
    cells.map((cell, place) => (place === at || place === at + 1 ? '' : cell.trim()));
  const keys = block.rows.map(({ cells }) => textAt(cells, at)).filter((cell) => cell !== '');
  if (!keys.every((key) => KEY.test(key))) return block;
  let before = '';
  const below = block.rows.map(({ cells }) => {
    const own = others(cells);
    const text = own.join('\t');
    const follows = isPair(cells) && before !== '' && (own.every((cell) => cell === '') || text === before);
    if (!follows) before = text.trim() === '' ? '' : text;
    return follows;
  });
  if (!below.includes(true)) return block;
  const rows = block.rows.map((row, place) => {
    if (!isPair(row.cells)) return row;
    const cells = below[place] ? row.cells.map(() => '') : [...row.cells];
    cells[at] = `${textAt(row.cells, at)}=${textAt(row.cells, at + 1).replace(/[\\;]/g, '\\$&')}`;
    cells[at + 1] = '';
    return { ...row, cells };
  });
  return { ...block, rows };
}

const textAt = (cells: readonly string[], at: number): string => cells[at]?.trim() ?? '';

const READ = /^(?:r|rd|read|readable|is readable|can read|lesen|lesbar|lecture|lectura|lettura|lezen|odczyt|读)$/;
const WRITE =
  /^(?:w|wr|write|writable|writeable|is writable|can write|schreiben|schreibbar|ecriture|escritura|scrittura|schrijven|zapis|写)$/;
const YES = /^(?:x|y|yes|true|1|j|ja|oui|o|si|s|sí|tak|t|r|w|read|write|✓|✔|✗✓|●|•|√|是)$/i;
const NO = /^(?:|-|–|—|n|no|not?|false|0|nein|non|nee|nie|×|✗|否|n\/?a)$/i;

/** Two columns that are marked where a register can be read and written become one: `R`, `W`, `R/W`. */
function withAccess(block: Block): Block {
  const [read, write] = [READ, WRITE].map((words) =>
    block.headers.findIndex((header) => words.test(plainHeader(header))),
  );
  if (read === undefined || write === undefined || read < 0 || write < 0) return block;
  const areMarks = (at: number) =>
    block.rows.every(({ cells }) => YES.test(textAt(cells, at)) || NO.test(textAt(cells, at)));
  if (!areMarks(read) || !areMarks(write)) return block;
  return withCells(block, (cells) => {
    const said = [YES.test(textAt(cells, read)) ? 'R' : '', YES.test(textAt(cells, write)) ? 'W' : ''].filter(Boolean);
    return { [read]: said.join('/'), [write]: '' };
  });
}

/** Columns that say yes or no of a type, and what is meant by either. */
const FLAGS = [
  {
    header: /^(?:signed|sign|is signed|vorzeichen|vorzeichenbehaftet|signe|con signo|con segno|有符号)$/,
    yes: 'signed',
    no: 'unsigned',
  },
  { header: /^(?:float|is float)$/, yes: 'float', no: '' },
] as const;

/** A column that says whether numbers have a sign, or are floating points, becomes one of types. */
function withFlags(block: Block): Block {
  return FLAGS.reduce((own, { header, yes, no }) => {
    const at = own.headers.findIndex((each) => header.test(plainHeader(each)));
    if (at < 0 || !own.rows.every(({ cells }) => YES.test(textAt(cells, at)) || NO.test(textAt(cells, at)))) return own;
    return withCells(own, (cells) => {
      const cell = textAt(cells, at);
      return cell === '' ? {} : { [at]: YES.test(cell) ? yes : no };
    });
  }, block);
}

const BITS =
  /^(?:bits?|bit (?:names?|fields?|descriptions?|meanings?|definitions?|map|list|assignment)|bitbelegung|bitnamen|flags?)$/;

/** Numbers with names below a header that speaks of bits are those of bits. */
function withBits(block: Block): Block {
  const at = block.headers.findIndex((header) => BITS.test(plainHeader(header)));
  if (at < 0) return block;
  return withCells(block, (cells) => {
    const { names, rest, bits, masks } = readPairs(textAt(cells, at));
    if (names.length === 0 || rest !== '' || bits || masks || names.some(({ number }) => number < 0 || number > 63))
      return {};
    return { [at]: names.map(({ number, name }) => `bit ${number}=${name.replace(/[\\;]/g, '\\$&')}`).join('; ') };
  });
}

/** The block with other cells in its rows, by the number of their column. */
const withCells = (block: Block, change: (cells: readonly string[]) => Readonly<Record<number, string>>): Block => ({
  ...block,
  rows: block.rows.map((row) => {
    const changed = change(row.cells);
    return Object.keys(changed).length === 0 ? row : { ...row, cells: Object.assign([...row.cells], changed) };
  }),
});
