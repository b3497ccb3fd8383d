import { expect, test } from 'vitest';
import { framePicture } from '../../../../src/workbench/index.ts';

test('a picture has the verdict, the cause, the strip and the lines, and is XML', () => {
  const svg = framePicture({
    verdict: 'Wrong CRC: RTU request, 8 bytes',
    wrong: true,
    cause: 'The source prints <E6 A1> & that is a misprint. '.repeat(4),
    fields: [
      { label: 'unit', kind: 'unit', cells: ['06'], note: '6', wrong: false },
      { label: 'checksum', kind: 'checksum', cells: ['E6', 'A1'], note: 'should be F5 E5', wrong: true },
    ],
    lines: [{ kind: 'unit', offset: '0', hex: '06', label: 'Unit', meaning: 'Unit 6.', problems: '' }],
  });
  for (const text of ['>Wrong CRC: RTU request, 8 bytes<', '>E6<', '>A1<', '>should be F5 E5<', '>Unit. Unit 6.<'])
    expect(svg).toContain(text);
  expect(svg).toContain('&lt;E6 A1&gt; &amp; that');
  // A long cause takes more than one line, and no line is wider than the picture.
  expect(svg.match(/misprint\./g)).toHaveLength(4);
  expect(svg.match(/font-weight="600">The source prints/g)!.length).toBeLessThan(4);
  // The same number of each tag opened and closed.
  expect(svg.match(/<text/g)).toHaveLength(svg.match(/<\/text>/g)!.length);
});

test('a strip that is wider than the picture goes on in a line below', () => {
  const field = (at: number) =>
    ({ label: `field ${at}`, kind: 'registers', cells: ['00', '01', '02', '03'], note: '', wrong: false }) as const;
  const heightOf = (count: number) =>
    Number(
      /height="([\d.]+)"/.exec(
        framePicture({
          verdict: 'Valid request',
          wrong: false,
          cause: '',
          fields: Array.from({ length: count }, (_, at) => field(at)),
          lines: [],
        }),
      )?.[1],
    );
  expect(heightOf(12)).toBeGreaterThan(heightOf(5));
});
