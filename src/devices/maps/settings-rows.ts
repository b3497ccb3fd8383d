import type { FactCode, SheetRow } from './sheet.ts';

/** What rows that begin with `#` say of all rows: `#convention,five-digit`. */
export interface SheetSettings {
  readonly facts: Readonly<Partial<Record<FactCode | Setting, string>>>;
  readonly serial?: readonly string[];
  readonly traits: readonly string[];
  readonly notes: readonly string[];
  readonly rows: readonly SheetRow[];
  readonly others: readonly SheetRow[];
}

type Setting = 'id' | 'name' | 'convention' | 'version';
const SINGLE = ['id', 'name', 'source', 'convention', 'version', 'table', 'counting', 'order', 'unit'] as const;

/** Takes the rows with settings out of those of a table. */
export function settingsOf(all: readonly SheetRow[]): SheetSettings {
  const facts: Partial<Record<FactCode | Setting, string>> = {};
  let serial: readonly string[] | undefined;
  const [traits, notes]: string[][] = [[], []];
  const rows: SheetRow[] = [];
  const others: SheetRow[] = [];
  for (const row of all) {
    if (!/^\s*#/.test(row.cells[0] ?? '')) {
      others.push(row);
      continue;
    }
    const [first = '', ...rest] = row.cells.map((cell) => cell.trim());
    const setting = first.slice(1).trim().toLowerCase();
    const value = rest[0] ?? '';
    const single = SINGLE.find((each) => each === setting);
    if (single && rest.slice(1).every((cell) => cell === '')) facts[single] = value;
    else if (setting === 'serial') serial = rest;
    else if (setting === 'trait') traits?.push(value);
    else if (setting === 'note') notes?.push(value);
    else {
      others.push(row);
      continue;
    }
    rows.push(row);
  }
  return { facts, ...(serial ? { serial } : {}), traits: traits ?? [], notes: notes ?? [], rows, others };
}
