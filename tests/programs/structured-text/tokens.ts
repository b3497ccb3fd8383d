/** The tokens of Structured Text, as strictly as matiec and CODESYS together: what one of them refuses is refused. */
export interface Token {
  readonly kind: 'name' | 'number' | 'real' | 'typed' | 'time' | 'string' | 'mark' | 'end';
  readonly text: string;
  readonly line: number;
}

/** What a strict compiler refuses, and where. */
export class Refused extends Error {
  readonly rule: string;

  constructor(rule: string, line: number, about = '') {
    super(`line ${line}: ${rule}${about === '' ? '' : ` (${about})`}`);
    this.rule = rule;
  }
}

const PATTERNS: readonly (readonly [Token['kind'] | 'blank' | 'comment', RegExp])[] = [
  ['blank', /\s+/y],
  ['comment', /\(\*[\s\S]*?\*\)/y],
  ['time', /T#\d+(?:ms|s)\b/y],
  ['typed', /[A-Z]+#(?:16#[\dA-F]+|-?\d+)\b/y],
  ['real', /\d+\.\d+(?:E[+-]\d+)?/y],
  ['number', /\d+\b/y],
  ['name', /[A-Za-z]\w*/y],
  ['string', /'(?:[^$']|\$[$'LNPRT])*'/y],
  ['mark', /:=|=>|<>|<=|>=|\.\.|[-+*/()[\],;:.<>=]/y],
];

export function tokensOf(text: string): readonly Token[] {
  const tokens: Token[] = [];
  let line = 1;
  for (let at = 0; at < text.length; ) {
    const rest = text.slice(at, at + 3);
    if (rest.startsWith('//')) throw new Refused('a comment begins with (*', line);
    if (/^(>>|<<|==|!=|&&|\|\||[&|^%{}"])/.test(rest))
      throw new Refused(`no operator ${rest.slice(0, 2).trim()}`, line);
    const found = PATTERNS.map(([kind, pattern]) => {
      pattern.lastIndex = at;
      return { kind, match: pattern.exec(text)?.[0] };
    }).find(({ match }) => match !== undefined);
    if (found?.match === undefined) throw new Refused('no token', line, JSON.stringify(text.slice(at, at + 20)));
    const { kind, match } = found;
    if (kind === 'comment' && match.slice(2).includes('(*')) throw new Refused('a comment in a comment', line);
    if (kind !== 'blank' && kind !== 'comment') tokens.push({ kind, text: match, line });
    line += match.split('\n').length - 1;
    at += match.length;
  }
  tokens.push({ kind: 'end', text: '', line });
  return tokens;
}
