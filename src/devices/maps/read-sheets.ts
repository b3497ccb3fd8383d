import { readFileText } from '../../notation/index.ts';
import { readDelimited } from './delimited.ts';
import { readObjects } from './objects.ts';
import type { SheetProblem, SheetsReading } from './sheet.ts';
import { looksLikeYaml, readYaml } from './yaml.ts';

/** The tables in a file or a text of any form. `name` is that of the file; its ending only helps where the content leaves a doubt. */
export function readSheets(source: Uint8Array | string, name = ''): SheetsReading {
  if (typeof source === 'string') return { ...readText(source, name), encoding: '' };
  const read = readFileText(source);
  if (!read) return { sheets: [], encoding: '', problems: [{ code: 'not-a-table' }], format: '' };
  return { ...readText(read.text, name), encoding: read.encoding };
}

type TextReading = Omit<SheetsReading, 'encoding'>;

function readText(marked: string, name: string): TextReading {
  const text = marked.replace(/^\uFEFF/, '');
  if (text.trim() === '') return { sheets: [], problems: [{ code: 'empty' }], format: '' };
  return (
    readJsonText(text) ?? readYamlText(text, name) ?? { sheets: [readDelimited(text)], problems: [], format: 'csv' }
  );
}

function readJsonText(text: string): TextReading | undefined {
  if (!/^\s*[[{]/.test(text)) return undefined;
  try {
    return readValues([JSON.parse(text)], 'json', []);
  } catch {
    return undefined;
  }
}

function readYamlText(text: string, name: string): TextReading | undefined {
  if (!/\.ya?ml$/i.test(name) && !looksLikeYaml(text)) return undefined;
  const problems: SheetProblem[] = [];
  return readValues(readYaml(text, problems), 'yaml', problems);
}

function readValues(values: readonly unknown[], format: string, problems: SheetProblem[]): TextReading {
  const sheets = values.flatMap((value) => readObjects(value, problems));
  return { sheets, problems, format: sheets.length > 0 ? format : '' };
}
