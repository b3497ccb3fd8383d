import type { TypeReading } from '../../notation/index.ts';
import { accessNamed, functionCodes, tableNamed } from './cell-words.ts';
import { readNamesCell, readPairs } from './names-cell.ts';
import { readRangeCell } from './range-cell.ts';
import { readScaleCell, readUnitCell, withoutGroups } from './scale-cell.ts';
import { readTypeCell } from './type-cell.ts';

/** Longer cells are seldom alike. */
const LONGEST = 64;

/** Answers the same for the same text without reading it again. */
function remembering<T>(read: (text: string) => T): (text: string) => T {
  const known = new Map<string, T>();
  return (text) => {
    if (text.length > LONGEST) return read(text);
    const found = known.get(text);
    if (found !== undefined || known.has(text)) return found as T;
    const answer = read(text);
    known.set(text, answer);
    return answer;
  };
}

/** Readers for the cells of one table, in whose scales `1,000` is one thousand or not, most of whose cells are like others: a table of 20,000 rows is read twice as fast with them. */
export function cellReaders({ groupedScales }: { readonly groupedScales: boolean }) {
  const types = new Map<number | undefined, (text: string) => TypeReading | undefined>();
  return {
    access: remembering(accessNamed),
    table: remembering(tableNamed),
    functions: remembering(functionCodes),
    names: remembering(readNamesCell),
    pairs: remembering(readPairs),
    range: remembering(readRangeCell),
    scale: remembering(groupedScales ? (text) => readScaleCell(withoutGroups(text)) : readScaleCell),
    unit: remembering(readUnitCell),
    type: (text: string, registers?: number) => {
      const read = types.get(registers) ?? remembering((cell) => readTypeCell(cell, registers));
      types.set(registers, read);
      return read(text);
    },
  };
}
export type CellReaders = ReturnType<typeof cellReaders>;
