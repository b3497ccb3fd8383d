import { type Rung, xmlText } from './rung.ts';

const ROW = 26;
const [LEFT, CONTACT, BLOCK, WIDTH, COIL, RIGHT] = [10, 90, 330, 200, 660, 720];
const TOP = 60;

/** The rung as an SVG, in the colours of what is around it. */
export function rungDrawing({ block, instance, contact, inputs, passed, coils }: Rung): string {
  const pins = [
    ['Execute', ''] as const,
    ...inputs.map(([name, , value]) => [name, value] as const),
    ...passed.map(([name]) => [name, name] as const),
  ];
  const rows = Math.max(pins.length, coils.length);
  const y = (row: number) => TOP + ROW * row;
  const bottom = y(rows);
  const line = (...path: readonly (string | number)[]) => `<path d="${path.join(' ')}"/>`;
  const text = (x: number, at: number, what: string, anchor = 'start') =>
    `<text x="${x}" y="${at}" text-anchor="${anchor}">${xmlText(what)}</text>`;
  const marks = [
    line('M', LEFT, 20, 'V', bottom, 'M', RIGHT, 20, 'V', bottom),
    line('M', LEFT, y(0), 'H', CONTACT, 'm', 0, -9, 'v', 18, 'm', 16, -18, 'v', 18, 'm', 0, -9, 'H', BLOCK),
    `<rect x="${BLOCK}" y="28" width="${WIDTH}" height="${bottom - 38}"/>`,
    ...pins.slice(1).map((_, index) => line('M', BLOCK - 14, y(index + 1), 'h', 14)),
    ...coils.map((_, row) =>
      line(
        'M',
        BLOCK + WIDTH,
        y(row),
        'H',
        COIL,
        'm',
        6,
        -9,
        'q',
        -8,
        9,
        0,
        18,
        'm',
        14,
        -18,
        'q',
        8,
        9,
        0,
        18,
        'm',
        4,
        -9,
        'H',
        RIGHT,
      ),
    ),
  ];
  const texts = [
    text(CONTACT + 8, y(0) - 16, contact, 'middle'),
    text(BLOCK + WIDTH / 2, 20, instance, 'middle'),
    text(BLOCK + WIDTH / 2, 44, block, 'middle'),
    ...pins.flatMap(([name, value], row) => [
      text(BLOCK + 6, y(row) + 4, name),
      ...(value === '' ? [] : [text(BLOCK - 18, y(row) + 4, value, 'end')]),
    ]),
    ...coils.flatMap(([output, coil], row) => [
      text(BLOCK + WIDTH - 6, y(row) + 4, output, 'end'),
      text(COIL - 6, y(row) - 5, coil, 'end'),
    ]),
  ];
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${RIGHT + 10} ${bottom + 10}" font-family="sans-serif" font-size="12">`,
    `  <title>${xmlText(`${contact} starts ${block}`)}</title>`,
    `  <g fill="none" stroke="currentColor">${marks.join('')}</g>`,
    `  <g fill="currentColor">${texts.join('')}</g>`,
    '</svg>',
  ].join('\n');
}
