import type { MapRow } from './map-row.ts';
import { readScaleCell, readUnitCell } from './scale-cell.ts';

/** What each option makes of a number, without words: `Flow temperature: 490 → 49 °C | 4900 °C`. */
export const exampleText = (row: MapRow | undefined, number: string, outcomes: readonly string[]): string | undefined =>
  row && `${shortName(row) || number}: ${number} → ${outcomes.join(' | ')}`;

const LONGEST = 40;
const shortName = (row: MapRow): string => {
  const name = (row.text('name') || row.text('description')).replace(/\s+/g, ' ');
  return name.length > LONGEST ? `${name.slice(0, LONGEST)}…` : name;
};

const RAW = 490;
const tidy = (number: number): string => String(Number(number.toPrecision(12)));

/** What a raw number is if the number of the scale multiplies, and if it divides. */
export function scaleExample(row: MapRow | undefined): string | undefined {
  const cell = row && readScaleCell(row.text('factor'));
  if (!row || !cell) return undefined;
  const unit = readUnitCell(cell.unit ?? row.text('unit')).unit;
  return exampleText(
    row,
    String(RAW),
    [RAW * cell.number, RAW / cell.number].map((value) => `${tidy(value)} ${unit}`.trim()),
  );
}
