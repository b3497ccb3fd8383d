import type { Block } from './header-rows.ts';
import { plainHeader } from './plain-header.ts';

/** Joins what columns say of values into one text, such as `0=Off`, where they only name one together. */
export const withValueNames = (block: Block): Block => withValueRows(withStates(block));

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
