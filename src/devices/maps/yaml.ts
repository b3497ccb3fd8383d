import { isAlias, isMap, isScalar, isSeq, Lexer, LineCounter, type ParsedNode, parseAllDocuments } from 'yaml';
import { isObject } from './loose.ts';
import type { SheetProblem } from './sheet.ts';

const DEEPEST = 100;
/** Characters of a text that count as one node. */
const NODE_CHARACTERS = 64;

/** Lines that look like YAML: a key with a colon, an item, a comment, a marker, or the end of a bracket. */
const LINE = /^\s*(?:#|---|\.\.\.|- |-$|[\]}]|(?:- )*(?:"[^"]*"|'[^']*'|[\w.$/ -]{1,60}):(?:\s|$))/;

/** Whether most lines of a text look like YAML, and one of them has a key. */
export function looksLikeYaml(text: string): boolean {
  // Objects of programs, whose keys have no quotes.
  if (/^\s*[{[]\s*(?:\{\s*)?[\w$]+\s*:/.test(text)) return true;
  const lines = text
    .slice(0, 20_000)
    .split(/\r?\n/)
    .filter((line) => line.trim() !== '');
  const fits = lines.filter((line) => LINE.test(line)).length;
  return fits * 10 >= lines.length * 6 && lines.some((line) => /^\s*(?:- )*[\w"'.-]+:(?:\s|$)/.test(line));
}

/**
 * The values of the documents in a text of YAML. A number stays the text it is unless its digits say the same (`0x10`, `0064`),
 * of a key that is there twice both values are kept, and aliases are written out up to a bound.
 */
export function readYaml(text: string, problems: SheetProblem[], most: number): readonly unknown[] {
  if (isTooDeep(text)) {
    problems.push({ code: 'unreadable', format: 'yaml', detail: 'too deep' });
    return [];
  }
  const lines = new LineCounter();
  let left = most;
  try {
    const documents = parseAllDocuments(text, {
      uniqueKeys: false,
      logLevel: 'silent',
      lineCounter: lines,
      prettyErrors: false,
    });
    if (!Array.isArray(documents)) return [];
    const [error] = documents.flatMap(({ errors }) => errors);
    if (error)
      problems.push({
        code: 'unreadable',
        format: 'yaml',
        detail: error.message,
        line: lines.linePos(error.pos[0]).line,
      });
    return documents.map((document) => {
      const anchors = new Map<string, ParsedNode>();
      return plainOf(document.contents, anchors, 0);
    });
  } catch (error) {
    problems.push({ code: 'unreadable', format: 'yaml', detail: error instanceof Error ? error.message : '' });
    return [];
  } finally {
    if (left < 0) problems.push({ code: 'too-many-cells', most });
  }

  function plainOf(node: ParsedNode | null, anchors: Map<string, ParsedNode>, depth: number): unknown {
    if (node === null || depth > DEEPEST || left-- < 0) return null;
    if (isAlias(node)) return plainOf(anchors.get(node.source) ?? null, anchors, depth + 1);
    if (node.anchor) anchors.set(node.anchor, node);
    if (isSeq(node)) return node.items.map((item) => plainOf(item, anchors, depth + 1));
    if (isMap(node)) {
      const own = new Map<string, unknown>();
      const merged: unknown[] = [];
      const times = new Map<string, number>();
      for (const { key, value } of node.items) {
        const name = isScalar(key) ? (key.source ?? String(key.value)) : '';
        const got = plainOf(value, anchors, depth + 1);
        const time = (times.get(name) ?? 0) + 1;
        times.set(name, time);
        if (name === '<<') merged.push(...(Array.isArray(got) ? got : [got]));
        else own.set(time > 1 ? `${name} ${time}` : name, got);
      }
      const below = merged.reverse().flatMap((each) => (isObject(each) ? Object.entries(each) : []));
      return Object.fromEntries([...below, ...own]);
    }
    const { value, source } = node;
    left -= Math.floor((source?.length ?? 0) / NODE_CHARACTERS);
    return typeof value === 'number' && source !== undefined && String(value) !== source ? source : value;
  }
}

/**
 * Whether a text nests deeper than it may. The reader of the package calls itself for each level, and an engine that runs out of stack
 * in it may take the page down. Text that only looks like levels counts, too.
 */
function isTooDeep(text: string): boolean {
  const levels: number[] = [];
  for (const line of text.split('\n')) {
    let run = 0;
    let inFront = true;
    for (const { 0: word, index } of line.matchAll(/\S+/g)) {
      if (inFront) {
        while (levels.length > 0 && (levels.at(-1) ?? 0) >= index) levels.pop();
        levels.push(index);
      }
      const indicates = /^(?:[-?:]$|[&!*])/.test(word);
      inFront &&= indicates;
      run = indicates ? run + 1 : 0;
      if (run > DEEPEST || levels.length > DEEPEST) return true;
    }
  }
  return (text.match(/[[{]/g)?.length ?? 0) > DEEPEST && bracketsNest(text);
}

/** Marks that the next piece is a plain scalar. */
const SCALAR = '\u001f';

function bracketsNest(text: string): boolean {
  let depth = 0;
  let before = '';
  for (const piece of new Lexer().lex(text)) {
    if (before !== SCALAR && (piece === '[' || piece === '{')) depth++;
    else if (before !== SCALAR && (piece === ']' || piece === '}')) depth--;
    if (depth > DEEPEST) return true;
    before = piece;
  }
  return false;
}
