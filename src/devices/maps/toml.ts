import { isObject } from './loose.ts';
import type { SheetProblem } from './sheet.ts';

/** Whether a text has a table header of TOML and keys with values below it. */
export const looksLikeToml = (text: string): boolean =>
  /^[ \t]*\[\[?[\w."' -]+\]\]?[ \t]*(?:#.*)?$/m.test(text) && /^[ \t]*[\w"'.-]+[ \t]*=[ \t]*\S/m.test(text);

const DEEPEST = 50;
const BARE = /[A-Za-z0-9_-]+/y;
const BLANK = /(?:[ \t]|#[^\n]*)*/y;
const SPACE = /(?:\s|#[^\n]*)*/y;
const SCALAR = /[^\s,\]}#]+/y;

class TomlError extends SyntaxError {}

type Table = Record<string, unknown>;

/** The value of a text of TOML (1.0), dates as texts. Up to the first error, which becomes a problem. */
export function readToml(text: string, problems: SheetProblem[]): unknown {
  const root: Table = Object.create(null);
  let table = root;
  let at = 0;
  try {
    for (skip(SPACE); at < text.length; skip(SPACE)) {
      if (text[at] === '[') header();
      else pair(table, 0);
      skip(BLANK);
      if (at < text.length && text[at] !== '\n' && text[at] !== '\r') fail('end of line expected');
    }
  } catch (error) {
    if (!(error instanceof TomlError)) throw error;
    problems.push({
      code: 'unreadable',
      format: 'toml',
      detail: error.message,
      line: text.slice(0, at).split('\n').length,
    });
  }
  return root;

  function fail(detail: string): never {
    throw new TomlError(detail);
  }

  function match(pattern: RegExp): string {
    pattern.lastIndex = at;
    const [found = ''] = pattern.exec(text) ?? [];
    at += found.length;
    return found;
  }

  function skip(pattern: RegExp): void {
    match(pattern);
  }

  function take(sign: string): void {
    if (!text.startsWith(sign, at)) fail(`${sign} expected`);
    at += sign.length;
  }

  function header(): void {
    const list = text.startsWith('[[', at);
    take(list ? '[[' : '[');
    const path = keys();
    take(list ? ']]' : ']');
    const last = path.pop() ?? '';
    const parent = path.reduce(inner, root);
    if (!list) table = inner(parent, last);
    else {
      const items = Array.isArray(parent[last]) ? parent[last] : [];
      parent[last] = items;
      table = Object.create(null);
      items.push(table);
    }
  }

  function inner(outer: Table, key: string): Table {
    const found = Array.isArray(outer[key]) ? outer[key].at(-1) : outer[key];
    if (isObject(found)) return found as Table;
    if (found !== undefined) fail(`${key} has a value`);
    const made: Table = Object.create(null);
    outer[key] = made;
    return made;
  }

  function keys(): string[] {
    const path: string[] = [];
    do {
      if (path.length > 0) take('.');
      skip(BLANK);
      const quoted = text[at] === '"' || text[at] === "'";
      const key = quoted ? string() : match(BARE);
      if (key === '' && !quoted) fail('key expected');
      path.push(key);
      skip(BLANK);
    } while (text[at] === '.' && path.length < DEEPEST);
    return path;
  }

  function pair(into: Table, depth: number): void {
    const path = keys();
    take('=');
    skip(BLANK);
    const last = path.pop() ?? '';
    path.reduce(inner, into)[last] = value(depth);
  }

  function value(depth: number): unknown {
    if (depth > DEEPEST) fail('too deep');
    if (text[at] === '"' || text[at] === "'") return string();
    if (text[at] === '[') return list(depth);
    if (text[at] === '{') return inline(depth);
    const word = match(SCALAR);
    if (word === '') fail('value expected');
    if (word === 'true' || word === 'false') return word === 'true';
    const number = Number(word.replaceAll('_', ''));
    return Number.isFinite(number) && String(number) === word ? number : word;
  }

  function list(depth: number): unknown[] {
    const items: unknown[] = [];
    take('[');
    for (skip(SPACE); text[at] !== ']'; skip(SPACE)) {
      items.push(value(depth + 1));
      skip(SPACE);
      if (text[at] !== ']') take(',');
    }
    take(']');
    return items;
  }

  /** Line ends in inline tables are not allowed, and used. */
  function inline(depth: number): Table {
    const made: Table = Object.create(null);
    take('{');
    for (skip(SPACE); text[at] !== '}'; skip(SPACE)) {
      pair(made, depth + 1);
      skip(SPACE);
      if (text[at] !== '}') take(',');
    }
    take('}');
    return made;
  }

  function string(): string {
    const quote = text[at] ?? '';
    const mark = text.startsWith(quote.repeat(3), at) ? quote.repeat(3) : quote;
    const from = at + mark.length;
    let end = text.indexOf(mark, from);
    while (quote === '"' && end >= 0 && isEscaped(end, from)) end = text.indexOf(mark, end + 1);
    if (end < 0 || (mark.length === 1 && text.slice(from, end).includes('\n'))) fail('string not closed');
    at = end + mark.length;
    const raw = text.slice(from, end).replace(/^\r?\n/, '');
    return quote === '"' ? unescaped(raw) : raw;
  }

  function isEscaped(end: number, from: number): boolean {
    let before = end;
    while (before > from && text[before - 1] === '\\') before--;
    return (end - before) % 2 === 1;
  }
}

const ESCAPES = new Map([
  ['b', '\b'],
  ['t', '\t'],
  ['n', '\n'],
  ['f', '\f'],
  ['r', '\r'],
]);

const unescaped = (raw: string): string =>
  raw.replace(
    /\\(?:u([\da-fA-F]{4})|U([\da-fA-F]{8})|\s*\n\s*|(.))/g,
    (_whole, short?: string, long?: string, letter?: string) => {
      const code = Number.parseInt(short ?? long ?? '', 16);
      if (!Number.isNaN(code)) return code <= 0x10ffff ? String.fromCodePoint(code) : '\ufffd';
      return letter === undefined ? '' : (ESCAPES.get(letter) ?? letter);
    },
  );
