import { type CellContext, readCells } from './cells.ts';
import type { Cells, LineFault, TableFault } from './fault.ts';
import type { Register } from './profile.ts';

/** A line as texts, or why it has no texts. */
export interface Line {
  readonly line: number;
  readonly cells: Cells | TableFault;
}

/** The registers of many lines, and what is wrong with the others. A line that says the same register again is kept once. */
export function collect(
  lines: readonly Line[],
  context: CellContext,
): { readonly registers: readonly Register[]; readonly faults: readonly LineFault[] } {
  const registers: Register[] = [];
  const faults: LineFault[] = [];
  const lineOf = new Map<string, number>();
  for (const { line, cells } of lines) {
    if ('code' in cells) {
      faults.push({ ...cells, line });
      continue;
    }
    const reading = readCells(cells, context);
    if (reading.kind === 'faults') {
      faults.push(...reading.faults.map((fault) => ({ ...fault, line })));
      continue;
    }
    const { name } = reading.register;
    const place = placeOf(reading.register);
    const first = lineOf.get(place);
    if (first !== undefined) {
      faults.push({ code: 'name-twice', name, first, line });
      continue;
    }
    lineOf.set(place, line);
    registers.push(reading.register);
  }
  return { registers, faults };
}

/** What tells registers of one name apart. */
export const placeOf = ({ name, table, address, mask, group, models }: Register): string =>
  JSON.stringify([name, table, address, mask, group, models]);
