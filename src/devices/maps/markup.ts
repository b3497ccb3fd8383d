import { dictionary } from '../../modbus/index.ts';

/** What is heard of a text of HTML or XML. A tag's name has no prefix; `attributeNamed` reads its attributes. */
export interface MarkupListener {
  readonly open: (name: string, attributes: string) => void;
  readonly close: (name: string) => void;
  readonly text: (text: string) => void;
}

/** Content that is not text. */
const RAW: ReadonlySet<string> = new Set(['script', 'style', 'title', 'template']);

/** Reads tags and text once, from the beginning to the end; what is not closed ends with the text. */
export function scanMarkup(source: string, listener: MarkupListener, kind: 'html' | 'xml'): void {
  let at = 0;
  while (at < source.length) {
    const tag = source.indexOf('<', at);
    const end = tag < 0 ? source.length : tag;
    if (end > at) listener.text(entitiesRead(source.slice(at, end)));
    if (tag < 0) return;
    if (source.startsWith('<!--', tag)) at = after(source, '-->', tag + 4);
    else if (source.startsWith('<![CDATA[', tag)) {
      at = after(source, ']]>', tag + 9);
      listener.text(source.slice(tag + 9, source.endsWith(']]>', at) ? at - 3 : at));
    } else if (source[tag + 1] === '!' || source[tag + 1] === '?') at = after(source, '>', tag + 1);
    else if (!/[\w/]/.test(source[tag + 1] ?? '')) {
      listener.text('<');
      at = tag + 1;
    } else at = element(source, tag, listener, kind);
  }
}

const after = (source: string, mark: string, from: number): number => {
  const found = source.indexOf(mark, from);
  return found < 0 ? source.length : found + mark.length;
};

function element(source: string, tag: number, listener: MarkupListener, kind: 'html' | 'xml'): number {
  const end = tagEnd(source, tag);
  const inner = source.slice(tag + 1, end);
  const closing = inner.startsWith('/');
  const [written = ''] = /^[^\s/>]+/.exec(closing ? inner.slice(1) : inner) ?? [];
  const local = written.slice(written.indexOf(':') + 1);
  const name = kind === 'html' ? written.toLowerCase() : local;
  if (closing) listener.close(name);
  else {
    listener.open(name, inner.slice(written.length));
    if (inner.endsWith('/') && kind === 'xml') listener.close(name);
    if (kind === 'html' && RAW.has(name)) {
      const close = new RegExp(`</${name}\\s*>`, 'gi');
      close.lastIndex = end;
      const found = close.exec(source);
      return found ? found.index : source.length;
    }
  }
  return end + 1;
}

/** Where the tag ends: the first `>` outside quotes. */
function tagEnd(source: string, tag: number): number {
  let quote = '';
  for (let at = tag + 1; at < source.length; at++) {
    const letter = source[at] ?? '';
    if (quote !== '') {
      if (letter === quote) quote = '';
    } else if (letter === '>') return at;
    else if ((letter === '"' || letter === "'") && source[at - 1] === '=') quote = letter;
  }
  return source.length;
}

/** Reads the value of an attribute, with or without a prefix, among those of a tag; `''` if the tag lacks it. */
export function attributeNamed(name: string): (attributes: string) => string {
  const pattern = new RegExp(`(?:^|[\\s:])${name}\\s*=\\s*(?:"([^"]*)"|'([^']*)'|([^\\s"'>]+))`, 'i');
  return (attributes) => {
    const found = pattern.exec(attributes);
    return entitiesRead(found?.[1] ?? found?.[2] ?? found?.[3] ?? '');
  };
}

/** Names of the characters from U+00A0 to U+00FF, in order. */
const LATIN =
  'nbsp iexcl cent pound curren yen brvbar sect uml copy ordf laquo not shy reg macr deg plusmn sup2 sup3 acute micro para middot cedil sup1 ordm raquo frac14 frac12 frac34 iquest Agrave Aacute Acirc Atilde Auml Aring AElig Ccedil Egrave Eacute Ecirc Euml Igrave Iacute Icirc Iuml ETH Ntilde Ograve Oacute Ocirc Otilde Ouml times Oslash Ugrave Uacute Ucirc Uuml Yacute THORN szlig agrave aacute acirc atilde auml aring aelig ccedil egrave eacute ecirc euml igrave iacute icirc iuml eth ntilde ograve oacute ocirc otilde ouml divide oslash ugrave uacute ucirc uuml yacute thorn yuml';

const ENTITIES: Readonly<Record<string, string>> = dictionary({
  ...Object.fromEntries(LATIN.split(' ').map((name, index) => [name, String.fromCharCode(0xa0 + index)])),
  amp: '&',
  lt: '<',
  gt: '>',
  quot: '"',
  apos: "'",
  ndash: '–',
  mdash: '—',
  hellip: '…',
  lsquo: '‘',
  rsquo: '’',
  ldquo: '“',
  rdquo: '”',
  bull: '•',
  euro: '€',
  le: '≤',
  ge: '≥',
  ne: '≠',
  minus: '−',
  Omega: 'Ω',
  omega: 'ω',
  phi: 'φ',
  Delta: 'Δ',
  mu: 'μ',
  permil: '‰',
  rarr: '→',
});

function entitiesRead(text: string): string {
  if (!text.includes('&')) return text;
  return text.replace(
    /&(?:#(\d{1,7})|#x([\da-f]{1,6})|(\w{2,8}));/gi,
    (whole, decimal?: string, hex?: string, name?: string) => {
      if (name !== undefined) return ENTITIES[name] ?? whole;
      const code = decimal === undefined ? Number.parseInt(hex ?? '', 16) : Number(decimal);
      return code > 0 && code <= 0x10ffff ? String.fromCodePoint(code) : whole;
    },
  );
}
