/**
 * The value of a text of JSON, also with comments and commas before a closing bracket, or the values of its lines; `undefined` of
 * another text.
 */
export function jsonIn(text: string): unknown {
  if (!/^\s*(?:[[{]|\/[/*])/.test(text)) return undefined;
  return parsed(text) ?? linesIn(text) ?? parsed(plainJson(text));
}

/** Why a text is not JSON, as the engine says it. */
export function jsonFault(text: string): string {
  try {
    JSON.parse(text);
    return '';
  } catch (error) {
    return error instanceof Error ? error.message : '';
  }
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

/** One object a line, as logs have them. */
function linesIn(text: string): unknown {
  const lines = text.split('\n').filter((line) => line.trim() !== '');
  if (lines.length < 2 || !lines.every((line) => /^\s*\{.*\}\s*$/.test(line))) return undefined;
  const values = lines.map(parsed);
  return values.includes(undefined) ? undefined : values;
}

/** The text without comments, and without commas before a closing bracket. */
function plainJson(text: string): string {
  const parts: string[] = [];
  let comma = false;
  let at = 0;
  while (at < text.length) {
    const from = at;
    if (text.startsWith('//', at)) at = after(text, '\n', at);
    else if (text.startsWith('/*', at)) at = after(text, '*/', at + 2);
    else if (text[at] === ',') {
      if (comma) parts.push(',');
      comma = true;
      at++;
    } else {
      at = text[at] === '"' ? stringEnd(text, at) : at + 1;
      const piece = text.slice(from, at);
      if (comma && piece.trim() !== '') {
        if (piece !== ']' && piece !== '}') parts.push(',');
        comma = false;
      }
      parts.push(piece);
    }
  }
  return parts.join('');
}

function after(text: string, mark: string, from: number): number {
  const found = text.indexOf(mark, from);
  return found < 0 ? text.length : found + mark.length;
}

function stringEnd(text: string, from: number): number {
  let at = from + 1;
  while (at < text.length && text[at] !== '"') at += text[at] === '\\' ? 2 : 1;
  return Math.min(text.length, at + 1);
}
