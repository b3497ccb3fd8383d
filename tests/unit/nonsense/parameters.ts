/** A parameter of a function as its source names it: by a name, or by the names of the fields that it takes apart. */
export type Parameter =
  | { readonly kind: 'name'; readonly name: string }
  | { readonly kind: 'fields'; readonly fields: readonly (readonly [key: string, value: Parameter])[] };

/** The parameters of a function, or of the constructor of a class. */
export function parametersOf(make: { toString(): string }, isClass: boolean): readonly Parameter[] {
  const source = make.toString();
  const from = source.indexOf('(', isClass ? source.indexOf('constructor(') : 0);
  return from < 0 ? [] : partsAt(source, from + 1).map(parameterOf);
}

/** What stands between commas from a place on, until the bracket closes that was open there. */
function partsAt(source: string, from: number): readonly string[] {
  const parts = [''];
  let depth = 0;
  for (const char of source.slice(from)) {
    if ('([{'.includes(char)) depth++;
    if (')]}'.includes(char) && --depth < 0) break;
    if (char === ',' && depth === 0) parts.push('');
    else parts.push((parts.pop() ?? '') + char);
  }
  return parts.map((part) => part.trim()).filter((part) => part !== '');
}

function parameterOf(part: string): Parameter {
  if (!part.startsWith('{')) return { kind: 'name', name: /[\w$]+/.exec(part)?.[0] ?? '' };
  const fields = partsAt(part, 1).map((field): readonly [string, Parameter] => {
    const [, key = '', inner] = /^([\w$]+|\.\.\.)(?:\s*:\s*(.*))?/s.exec(field) ?? [];
    return [key, inner?.startsWith('{') ? parameterOf(inner) : { kind: 'name', name: key }];
  });
  return { kind: 'fields', fields };
}
