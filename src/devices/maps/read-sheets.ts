import { readFileText } from '../../notation/index.ts';
import { readDelimited } from './delimited.ts';
import type { SheetsReading } from './sheet.ts';

/** The tables in a file or a text of any form. `name` is that of the file; its ending only helps where the content leaves a doubt. */
export function readSheets(source: Uint8Array | string, name = ''): SheetsReading {
  if (typeof source === 'string') return { ...readText(source, name), encoding: '' };
  const read = readFileText(source);
  if (!read) return { sheets: [], encoding: '', problems: [{ code: 'not-a-table' }], format: '' };
  return { ...readText(read.text, name), encoding: read.encoding };
}

function readText(marked: string, _name: string): Omit<SheetsReading, 'encoding'> {
  const text = marked.replace(/^\uFEFF/, '');
  if (text.trim() === '') return { sheets: [], problems: [{ code: 'empty' }], format: '' };
  return { sheets: [readDelimited(text)], problems: [], format: 'csv' };
}
