import { dictionary } from '../../modbus/index.ts';

/** Names and values in the order in which they stand. */
export type Query = readonly (readonly [name: string, value: string])[];

/** Writes a query as a form does (`a=1&b=x+y`); half a surrogate pair becomes U+FFFD. */
export const writeQuery = (query: Query): string =>
  query.map(([name, value]) => `${escaped(name)}=${escaped(value)}`).join('&');

/** Reads what `writeQuery` or a browser wrote. Escapes that are not UTF-8 stay as they stand. */
export const readQuery = (text: string): Query =>
  text
    .split('&')
    .filter((part) => part !== '')
    .map((part) => {
      const at = part.indexOf('=');
      return at < 0 ? [unescaped(part), ''] : [unescaped(part.slice(0, at)), unescaped(part.slice(at + 1))];
    });

const escaped = (text: string): string =>
  encodeURIComponent(text.replace(/\p{Surrogate}/gu, '\uFFFD'))
    .replaceAll('%20', '+')
    .replace(/[!~'()]/g, (mark) => ESCAPES[mark] ?? mark);

/** Marks that a form escapes and `encodeURIComponent` does not. */
const ESCAPES: Readonly<Record<string, string>> = dictionary({
  '!': '%21',
  '~': '%7E',
  "'": '%27',
  '(': '%28',
  ')': '%29',
});

const unescaped = (text: string): string => text.replaceAll('+', ' ').replace(/(?:%[0-9a-f]{2})+/gi, decoded);

function decoded(escapes: string): string {
  try {
    return decodeURIComponent(escapes);
  } catch {
    return escapes;
  }
}
