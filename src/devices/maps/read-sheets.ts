import { readFileText } from '../../notation/index.ts';
import { readDelimited } from './delimited.ts';
import { readHtml } from './html.ts';
import { jsonFault, jsonIn } from './json-text.ts';
import { looksLikeMarkdown, readMarkdown } from './markdown.ts';
import { knownExport, readModpoll, readNamed, readOwn } from './named/index.ts';
import { readObjects } from './objects.ts';
import { type SheetLimits, type SheetProblem, type SheetsReading, usualLimits } from './sheet.ts';
import { looksLikeToml, readToml } from './toml.ts';
import { gunzip, TooLarge, unzip } from './unpack.ts';
import { isPartOfWorkbook, isWorkbook, readWorkbook } from './workbook.ts';
import { looksLikeYaml, readYaml } from './yaml.ts';

/** The tables in a file or a text of any form. `name` is that of the file; its ending only helps where the content leaves a doubt. */
export function readSheets(source: Uint8Array | string, name = '', limits = usualLimits): SheetsReading {
  if (typeof source === 'string') return { ...readText(source, name, limits), encoding: '' };
  const container = CONTAINERS.find(({ magic }) => magic.every((byte, index) => source[index] === byte));
  if (container) return readContainer(container, source, name, limits);
  const read = readFileText(source);
  if (!read) return nothing({ code: 'not-a-table' });
  return { ...readText(read.text, name, limits), encoding: read.encoding };
}

type TextReading = Omit<SheetsReading, 'encoding'>;

const nothing = (problem: SheetProblem): SheetsReading => ({
  sheets: [],
  encoding: '',
  problems: [problem],
  format: '',
});

interface Container {
  readonly format: string;
  /** The first bytes of such files. */
  readonly magic: readonly number[];
}

const CONTAINERS: readonly Container[] = [
  { format: 'gzip', magic: [0x1f, 0x8b] },
  { format: 'zip', magic: [0x50, 0x4b, 0x03, 0x04] },
  { format: 'xls', magic: [0xd0, 0xcf, 0x11, 0xe0] },
  { format: 'pdf', magic: [0x25, 0x50, 0x44, 0x46] },
];

function readContainer({ format }: Container, bytes: Uint8Array, name: string, limits: SheetLimits): SheetsReading {
  try {
    if (format === 'gzip') return readSheets(gunzip(bytes, limits.bytes), name.replace(/\.gz$/i, ''), limits);
    if (format !== 'zip') return nothing({ code: 'not-a-table', format });
    const files = unzip(bytes, isPartOfWorkbook, limits.bytes);
    if (!isWorkbook(files)) return nothing({ code: 'not-a-table', format });
    const problems: SheetProblem[] = [];
    const sheets = readWorkbook(files, problems, limits);
    return { sheets, encoding: '', problems, format: 'xlsx' };
  } catch (error) {
    if (error instanceof TooLarge) return nothing({ code: 'too-large', most: limits.bytes });
    return nothing({ code: 'unreadable', format, detail: error instanceof Error ? error.message : '' });
  }
}

function readText(marked: string, name: string, limits: SheetLimits): TextReading {
  const text = marked.replace(/^\uFEFF/, '');
  if (text.trim() === '') return { sheets: [], problems: [{ code: 'empty' }], format: '' };
  return (
    readJsonText(text, name, limits) ??
    readHtmlText(text, limits) ??
    readTomlText(text, name, limits) ??
    readMarkdownText(text) ??
    readYamlText(text, name, limits) ??
    brokenJson(text) ??
    readDelimitedText(text)
  );
}

function readJsonText(text: string, name: string, limits: SheetLimits): TextReading | undefined {
  const value = jsonIn(text);
  if (value === undefined) return undefined;
  const problems: SheetProblem[] = [];
  const own = readOwn(text, value, problems);
  if (own) return { sheets: own, problems, format: 'framewright' };
  return readValues([value], /\.mbmap\.json$/i.test(name) ? 'mbmap' : 'json', problems, limits);
}

/** What begins like JSON, and is nothing else. */
const brokenJson = (text: string): TextReading | undefined =>
  /^\s*(?:\{\s*"|\[\s*[{[])/.test(text)
    ? { sheets: [], problems: [{ code: 'unreadable', format: 'json', detail: jsonFault(text) }], format: '' }
    : undefined;

function readHtmlText(text: string, limits: SheetLimits): TextReading | undefined {
  if (!/<table[\s>]/i.test(text)) return undefined;
  const problems: SheetProblem[] = [];
  const sheets = readHtml(text, problems, limits.cells);
  return sheets.length > 0 || problems.length > 0 ? { sheets, problems, format: 'html' } : undefined;
}

const readMarkdownText = (text: string): TextReading | undefined =>
  looksLikeMarkdown(text) ? { sheets: readMarkdown(text), problems: [], format: 'markdown' } : undefined;

function readYamlText(text: string, name: string, limits: SheetLimits): TextReading | undefined {
  if (!/\.ya?ml$/i.test(name) && !looksLikeYaml(text)) return undefined;
  const problems: SheetProblem[] = [];
  const read = readValues(readYaml(text, problems, limits.nodes), 'yaml', problems, limits);
  return read.sheets.length === 0 && brokenJson(text) ? undefined : read;
}

function readTomlText(text: string, name: string, limits: SheetLimits): TextReading | undefined {
  if (!/\.toml$/i.test(name) && !looksLikeToml(text)) return undefined;
  const problems: SheetProblem[] = [];
  return readValues([readToml(text, problems)], 'toml', problems, limits);
}

function readDelimitedText(text: string): TextReading {
  const read = readDelimited(text);
  const devices = readModpoll(read);
  if (devices) return { sheets: devices, problems: [], format: devices[0]?.format ?? '' };
  const sheet = knownExport(read);
  return { sheets: [sheet], problems: [], format: sheet.format ?? 'csv' };
}

function readValues(
  values: readonly unknown[],
  format: string,
  problems: SheetProblem[],
  limits: SheetLimits,
): TextReading {
  const sheets = values.flatMap((value) => readNamed(value) ?? readObjects(value, problems, limits.cells));
  return {
    sheets,
    problems,
    format: sheets.find((sheet) => sheet.format !== undefined)?.format ?? (sheets.length > 0 ? format : ''),
  };
}
