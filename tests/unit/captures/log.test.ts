import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readCapture } from '../../../src/captures/index.ts';

// AP 6.3 as RTU: registers 108 to 110 are asked for and answered.
const ASK = '11 03 00 6B 00 03 76 87';
const REPLY = '11 03 06 02 2B 00 00 00 64 C8 BA';

const read = (text: string) => readCapture(new TextEncoder().encode(text));
const pieces = (text: string) =>
  (read(text).pieces ?? []).map(({ before, record: { bytes, time, known } }) => ({
    before,
    hex: Buffer.from(bytes).toString('hex'),
    ...(time !== undefined && { time }),
    why: known?.why,
    ...(known?.text !== undefined && { text: known.text }),
    line: known?.line,
  }));

describe('the side of a frame', () => {
  const sides = (text: string) => Array.from(read(text).records, ({ side }) => side);

  it('is that of a reply for the echo of a request, which no reply to it can be', () => {
    expect(sides(`Tx ${ASK}\nRx ${ASK}\nRx ${REPLY}\nTx ${ASK}\nRx ${REPLY}`)).toEqual([
      'request',
      'response',
      'response',
      'request',
      'response',
    ]);
  });

  it('is that of a request for one that is sent again, or heard by a server', () => {
    expect(sides(`Tx ${ASK}\nTx ${ASK}\nRx ${REPLY}`)).toEqual(['request', 'request', 'response']);
    expect(sides(`Rx ${ASK}\nTx ${REPLY}\nRx ${ASK}\nRx ${ASK}\nTx ${REPLY}`)).toEqual([
      'request',
      'response',
      'request',
      'request',
      'response',
    ]);
    // Write Single Register (AP 6.6): the reply of a server is the request.
    const write = '11 06 00 01 00 03 9A 9B';
    const served = `Rx ${ASK}\nTx ${REPLY}\nRx ${write}\nTx ${write}\nRx ${write}\nTx ${write}`;
    expect(sides(served).map((side) => side === 'request')).toEqual([true, false, true, false, true, false]);
  });
});

describe('the pieces of a text that are in no frame', () => {
  it('stand between the frames where they are, with their line and their time', () => {
    const text = [
      '09:59:59.000 Rx 21 00 00',
      `10:00:00.000 Tx ${ASK}`,
      `10:00:00.016 Rx ${REPLY}`,
      '',
      '10:00:01.000 Rx FF FE',
      `10:00:02.000 Tx ${ASK}`,
    ].join('\n');
    // Times count from the first frame.
    expect(pieces(text)).toEqual([
      { before: 0, hex: '210000', time: -1_000_000, why: 'no-frame', line: 1 },
      { before: 2, hex: 'fffe', time: 1_000_000, why: 'no-frame', line: 5 },
    ]);
    expect(Array.from(read(text).records, ({ time }) => time)).toEqual([0, 16_000, 2_000_000]);
  });

  it('are what libmodbus prints of a reply that broke off', () => {
    const line = (text: string, [open, close]: string) => text.replace(/\w\w ?/g, (pair) => open + pair.trim() + close);
    const text = `${line(ASK, '[]')}\nWaiting for a confirmation...\n${line('21 00 00', '<>')}\nERROR Connection timed out\n`;
    expect(pieces(text)).toEqual([{ before: 1, hex: '210000', why: 'no-frame', line: 3 }]);
  });

  it('are its words, where they are not bytes: those of a kind in a line are one piece', () => {
    const text = `Tx ${ASK}\nRx 11 03 06 02 2B 0G 1G 00 64 C8 BA\nRx ${REPLY}`;
    const words = pieces(text).filter(({ text: said }) => said !== undefined);
    expect(words).toEqual([{ before: 2, hex: '', why: 'not-a-byte', text: '0G 1G', line: 2 }]);
  });

  it('are problems too, of which words that are never bytes are not pieces', () => {
    const text = `Tx ${ASK}\nRx FF FE\nTimeout after 12 34 tries`;
    const { problems, pieces: found = [] } = read(text);
    expect(problems.map(({ code }) => code)).toEqual(['no-frame', 'set-aside']);
    expect(found.map(({ problem }) => problem)).toEqual([problems[0]]);
  });

  it('are those of a stream of bytes as well', () => {
    const bytes = Uint8Array.from(Buffer.from(`8081FD${ASK}${REPLY}`.replaceAll(' ', ''), 'hex'));
    const { pieces: found = [], records } = readCapture(bytes);
    expect(records.length).toBe(2);
    expect(found).toMatchObject([{ before: 0, record: { place: { kind: 'bytes', from: 0, to: 3 } } }]);
  });

  it('leave no byte out, and repeat none', () => {
    const chunk = fc
      .uint8Array({ minLength: 1, maxLength: 5 })
      .map((bytes) => `Rx ${Buffer.from(bytes).toString('hex')}`);
    const line = fc.oneof(chunk, fc.constantFrom(`Tx ${ASK}`, `Rx ${REPLY}`));
    fc.assert(
      fc.property(fc.array(line, { maxLength: 12 }), (lines) => {
        const { records, pieces: found = [] } = read(lines.join('\n'));
        const order = Array.from(records, ({ place }) => place);
        for (const [at, { before, record }] of found.entries()) {
          const [piece, next] = [record.place, order[before]];
          const last = order[before - 1];
          const from = (place: typeof piece | undefined) => (place?.kind === 'text' ? place.from : undefined);
          expect(from(next) ?? Number.POSITIVE_INFINITY).toBeGreaterThan(from(piece) ?? 0);
          expect(from(last) ?? -1).toBeLessThan(from(piece) ?? 0);
          expect(before).toBeGreaterThanOrEqual(found[at - 1]?.before ?? 0);
        }
      }),
    );
  });
});
