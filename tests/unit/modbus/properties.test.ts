import fc from 'fast-check';
import { describe, expect, test, vi } from 'vitest';
import {
  type DecodeContext,
  type Direction,
  decodeFrame,
  encodeFrame,
  functionCodes,
  type ProblemCode,
  toHex,
} from '../../../src/modbus/index.ts';
import {
  anyBytes,
  anyCharacters,
  anyDirection,
  anyLegalFrame,
  anyTransport,
  directions,
  legalFields,
  legalFrame,
  transports,
} from './arbitraries.ts';
import { encodedAgain, expectEveryByteInOneSpan, isFlagged } from './frames.ts';
import { bitwiseCrc } from './reference.ts';
import { brokenFrames, frames } from './vectors.ts';

// These take a second or two each, and longer on a machine that is busy with other things.
vi.setConfig({ testTimeout: 60_000 });

/** What holds of every reading of every bytes. Plain comparisons, for they are made many thousand times. */
function expectSound(bytes: Uint8Array, context: DecodeContext): void {
  const before = toHex(bytes);
  const reading = decodeFrame(bytes, context);
  expectEveryByteInOneSpan(reading, bytes.length);
  const again = encodedAgain(reading);
  if (again !== before) expect(again).toBe(before);
  if (toHex(bytes) !== before) expect.unreachable('the bytes were changed');
  const { outcome, problems } = reading;
  for (const { span, section, severity } of problems) {
    if (!/^(?:AP|SL|TG|PI) (?:\d|App\. |Annex )/.test(section)) expect.unreachable(`${section} is no section`);
    if (!['error', 'warning', 'note'].includes(severity)) expect.unreachable(`${severity} is no severity`);
    if (span.from < 0 || span.to < span.from || span.to > bytes.length) expect.unreachable(`${span.name} is outside`);
  }
  const says = (code: ProblemCode) => problems.some((problem) => problem.code === code);
  if (says('frame-short') !== (outcome.kind === 'short')) expect.unreachable(`${outcome.kind} and frame-short`);
  if (says('frame-extra') !== (outcome.kind === 'extra')) expect.unreachable(`${outcome.kind} and frame-extra`);
  if (outcome.kind === 'short' && outcome.missing < 1) expect.unreachable('short by nothing');
  if (outcome.kind === 'extra' && (outcome.bytes < 1 || outcome.bytes > bytes.length)) expect.unreachable('no extra');
}

describe('any bytes whatsoever have a reading that covers them and gives them back', () => {
  test('in any transport and direction, with any request', () => {
    fc.assert(
      fc.property(anyBytes, anyTransport, anyDirection, fc.option(anyBytes), (bytes, transport, direction, request) => {
        expectSound(bytes, { transport, direction, request: request ?? undefined });
      }),
      { numRuns: 500 },
    );
  });

  test('characters in ASCII', () => {
    fc.assert(
      fc.property(anyCharacters, anyDirection, (bytes, direction) =>
        expectSound(bytes, { transport: 'ascii', direction }),
      ),
      { numRuns: 300 },
    );
  });

  test('legal frames cut, torn, doubled and with a byte changed', () => {
    const harmed = fc.tuple(anyLegalFrame, fc.nat(), fc.nat(0xff), fc.nat(5)).map(([input, where, byte, how]) => {
      const bytes = encodeFrame(input);
      const at = where % bytes.length;
      const [head, tail] = [bytes.subarray(0, at), bytes.subarray(at)];
      const ways = [
        () => head,
        () => tail,
        () => Uint8Array.of(...head, byte, ...tail),
        () => Uint8Array.of(...head, ...tail.subarray(1)),
        () => Uint8Array.of(...head, byte, ...tail.subarray(1)),
        () => Uint8Array.of(...bytes, ...bytes),
      ];
      return { input, bytes: (ways[how] as () => Uint8Array)() };
    });
    fc.assert(
      fc.property(harmed, anyDirection, ({ input, bytes }, direction) => {
        expectSound(bytes, { transport: input.transport, direction });
      }),
      { numRuns: 500 },
    );
  });

  test('every collected frame, valid and broken, read as every other kind of frame', () => {
    for (const { hex } of [...frames, ...brokenFrames]) {
      const bytes = Uint8Array.from(Buffer.from(hex, 'hex'));
      for (const transport of transports) {
        for (const direction of directions) expectSound(bytes, { transport, direction });
      }
    }
  });
});

describe('encode then decode gives the inputs back, and nothing against them', () => {
  test('there are legal inputs for every function', () => {
    expect(Object.keys(legalFields).map(Number)).toEqual(functionCodes.map(({ code }) => code));
  });

  const cases = functionCodes.flatMap(({ code, name }) => directions.map((direction) => ({ code, name, direction })));
  test.each(cases)('$code $name, $direction', ({ code, direction }) => {
    for (const transport of transports) {
      fc.assert(
        fc.property(legalFrame(code, transport, direction), (input) => {
          const reading = decodeFrame(encodeFrame(input), { transport, direction });
          expect(reading).toMatchObject(input);
          const { fields, outcome, forced, problems } = reading;
          const other = problems.filter(({ severity }) => severity !== 'note');
          const said = JSON.stringify([Object.keys(fields).sort(), outcome, forced, other]);
          const wanted = JSON.stringify([Object.keys(input.fields).sort(), { kind: 'whole' }, {}, []]);
          if (said !== wanted) expect(said).toBe(wanted);
        }),
        { numRuns: 40 },
      );
    }
  });
});

describe('any one-bit change of an RTU or ASCII frame is reported', () => {
  const flippedIsFlagged = (bytes: Uint8Array, bit: number, context: DecodeContext) => {
    const changed = bytes.slice();
    changed[bit >> 3] = (changed[bit >> 3] as number) ^ (1 << (bit & 7));
    return isFlagged(decodeFrame(changed, context));
  };

  test.each(['rtu', 'ascii'] as const)('every bit of the collected %s frames', (transport) => {
    for (const frame of frames) {
      const bytes = Uint8Array.from(Buffer.from(frame.hex, 'hex'));
      if (frame.transport !== transport || bytes.length > 64) continue;
      for (let bit = 0; bit < 8 * bytes.length; bit++) {
        const { id, direction } = frame;
        if (!flippedIsFlagged(bytes, bit, { transport, direction })) expect.unreachable(`${id}, bit ${bit}`);
      }
    }
  });

  test('any bit of any legal frame', () => {
    const oneBit = fc.tuple(anyLegalFrame, fc.nat()).filter(([{ transport }]) => /rtu|ascii/.test(transport));
    fc.assert(
      fc.property(oneBit, ([input, bit]) => {
        const bytes = encodeFrame(input);
        expect(flippedIsFlagged(bytes, bit % (8 * bytes.length), input)).toBe(true);
      }),
      { numRuns: 700 },
    );
  });
});

describe('the beginning of a legal frame is short, by no more than what is missing', () => {
  const cut = fc.tuple(anyLegalFrame, fc.nat()).map(([input, where]) => {
    const bytes = encodeFrame(input);
    return { input, bytes, there: where % bytes.length };
  });
  /** No byte tells where these end. */
  const isOpen = ({ functionCode, fields }: { functionCode?: number | undefined; fields: Record<string, unknown> }) =>
    (functionCode === 0x08 && fields['subFunction'] === 0) || (functionCode === 0x2b && fields['meiType'] === 13);

  test('RTU, unless its CRC holds by chance; TCP, whose length field tells; a PDU', () => {
    fc.assert(
      fc.property(cut, ({ input, bytes, there }) => {
        const beginning = bytes.subarray(0, there);
        const { transport } = input;
        fc.pre(transport === 'tcp' || (transport !== 'ascii' && !isOpen(input)));
        fc.pre(transport !== 'rtu' || bitwiseCrc(beginning) !== 0);
        const { outcome } = decodeFrame(beginning, input);
        expect(outcome.kind).toBe('short');
        const missing = outcome.kind === 'short' ? outcome.missing : 0;
        expect(missing).toBeLessThanOrEqual(bytes.length - there);
        if (transport === 'tcp' && there >= 6) expect(missing).toBe(bytes.length - there);
      }),
      { numRuns: 700 },
    );
  });
});

describe('a megabyte is read like any other bytes', () => {
  const MEGABYTE = 1 << 20;
  /** Bytes that look like chance and are the same in every run. */
  const scrambled = () => {
    let state = 1;
    return new Uint8Array(MEGABYTE).map(() => {
      state = (Math.imul(state, 1103515245) + 12345) >>> 0;
      return state >>> 24;
    });
  };
  const repeated = (text: string) => new Uint8Array(MEGABYTE).map((_, i) => text.charCodeAt(i % text.length));
  const large: readonly (readonly [what: string, direction: Direction, bytes: Uint8Array])[] = [
    ['scrambled bytes', 'request', scrambled()],
    ['colons', 'request', repeated(':')],
    ['frames of digits', 'response', repeated(':1103006B00037E\r\n')],
    ['a user’s function', 'request', repeated('A')],
    ['objects', 'response', repeated('\x01\x2b\x0e\x01\x01\x00\x00\xff')],
  ];

  test.each(large)('%s, in a %s', (_what, direction, bytes) => {
    for (const transport of transports) {
      expectEveryByteInOneSpan(decodeFrame(bytes, { transport, direction }), bytes.length);
    }
  });
});
