import { dictionary, type FieldKind } from '../../modbus/index.ts';
import type { ExplanationRow } from './explanation.ts';

/** A field in the strip of the picture. */
export interface PictureField {
  readonly label: string;
  readonly kind: FieldKind;
  /** What stands in its cells. */
  readonly cells: readonly string[];
  readonly note: string;
  readonly wrong: boolean;
}

/** What a picture of an explained frame says. */
export interface PictureText {
  readonly verdict: string;
  readonly wrong: boolean;
  /** Empty if there is nothing to say. */
  readonly cause: string;
  readonly fields: readonly PictureField[];
  readonly lines: readonly Pick<ExplanationRow, 'kind' | 'offset' | 'hex' | 'label' | 'meaning' | 'problems'>[];
}

/** Pixels. */
const WIDTH = 880;
const MARGIN = 16;
const CELL = 34;
const LINE = 18;
/** How wide a character is, about, in parts of its height. */
const SANS = 0.54;
const MONO = 0.61;
const SMALL = 12;
const TEXT = 13;

/** Light colours, since a picture has no theme. */
const INK = '#1b1d1f';
const SOFT = '#5d6166';
const BAD = '#a8201a';
const GOOD = '#0f6b3a';
const KINDS: Readonly<Partial<Record<FieldKind, string>>> = {
  unit: '#5b6470',
  envelope: '#5b6470',
  function: '#3f4fb0',
  address: '#00705f',
  quantity: '#6b6200',
  count: '#6b6200',
  checksum: '#a1306f',
  rest: BAD,
};
const colourOf = (kind: FieldKind) => KINDS[kind] ?? '#9a5b00';

/** A frame's strip and the lines that explain it, as SVG with everything in itself. */
export function framePicture({ verdict, wrong, cause, fields, lines }: PictureText): string {
  const parts: string[] = [];
  const text = (x: number, y: number, what: string, { size = TEXT, colour = INK, bold = false, mono = false } = {}) =>
    parts.push(
      `<text x="${x}" y="${y}" font-size="${size}" fill="${colour}" font-family="${mono ? 'monospace' : 'sans-serif'}"${bold ? ' font-weight="600"' : ''}>${escaped(what)}</text>`,
    );
  let y = MARGIN + TEXT;
  text(MARGIN, y, verdict, { colour: wrong ? BAD : GOOD, bold: true });
  for (const line of wrapped(cause, WIDTH - 2 * MARGIN, TEXT)) {
    y += LINE;
    text(MARGIN, y, line, { bold: true });
  }
  y += LINE;
  let x = MARGIN;
  for (const field of fields) {
    const width = Math.max(
      field.cells.length * CELL,
      ...[field.label, field.note].map((said) => said.length * SMALL * SANS),
    );
    if (x > MARGIN && x + width > WIDTH - MARGIN) {
      x = MARGIN;
      y += 70;
    }
    const colour = field.wrong ? BAD : colourOf(field.kind);
    text(x, y + SMALL, field.label, { size: SMALL, colour, bold: true });
    parts.push(
      `<rect x="${x}" y="${y + 17}" width="${field.cells.length * CELL}" height="26" rx="5" fill="${colour}" fill-opacity="0.09" stroke="${colour}"/>`,
    );
    field.cells.forEach((cell, at) => {
      text(x + at * CELL + (CELL - cell.length * 15 * MONO) / 2, y + 35, cell, { size: 15, bold: true, mono: true });
    });
    text(x, y + 57, field.note, { size: SMALL, colour: field.wrong ? BAD : SOFT });
    x += width + 12;
  }
  y += 70;
  for (const { kind, offset, hex, label, meaning, problems } of lines) {
    parts.push(`<path d="M${MARGIN} ${y}H${WIDTH - MARGIN}" stroke="#dcdcd6"/>`);
    const said = [
      ...wrapped(`${label && `${label}. `}${meaning}`, WIDTH - 220 - MARGIN, TEXT).map((line) => ({
        line,
        colour: INK,
      })),
      ...wrapped(problems.replaceAll('\n', ' '), WIDTH - 220 - MARGIN, TEXT).map((line) => ({ line, colour: BAD })),
    ];
    text(MARGIN, y + LINE, offset, { mono: true, colour: SOFT });
    text(MARGIN + 56, y + LINE, hex, { mono: true, colour: colourOf(kind), bold: true });
    for (const { line, colour } of said) {
      y += LINE;
      text(220, y, line, { colour });
    }
    y += 8;
  }
  y += MARGIN / 2;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${y}" viewBox="0 0 ${WIDTH} ${y}"><rect width="100%" height="100%" fill="#ffffff"/>${parts.join('')}</svg>`;
}

/** A text in lines that are about as wide as this at most; none if it is empty. */
function wrapped(text: string, width: number, size: number): readonly string[] {
  const most = Math.floor(width / (size * SANS));
  const lines: string[] = [];
  for (const word of text.split(' ').filter((each) => each !== '')) {
    const last = lines.at(-1);
    if (last !== undefined && last.length + 1 + word.length <= most) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}

const ENTITIES: Readonly<Record<string, string>> = dictionary({
  '&': '&amp;',
  '<': '&lt;',
  '>': '&gt;',
  '"': '&quot;',
});

const escaped = (text: string) => text.replace(/[&<>"]/g, (character) => ENTITIES[character] ?? character);
