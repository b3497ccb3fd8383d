import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  addFinding,
  countFindings,
  defaultRules,
  defaultSettings,
  estimateScan,
  type LinkSettings,
  mayChange,
  requestsOf,
  type ScanFinding,
  type ScanNews,
  type ScanOrder,
  Session,
  type SessionNews,
  supports,
} from '../../../src/bus/index.ts';
import { searchAddresses } from '../../../src/bus/scan/address-search.ts';
import { decodeFrame } from '../../../src/modbus/index.ts';
import { hex } from '../modbus/frames.ts';
import { AnsweringLink } from './answering-link.ts';
import { VirtualClock } from './virtual-clock.ts';

const text = (bytes: Uint8Array) => Buffer.from(bytes).toString('hex').toUpperCase();
const line: LinkSettings = { ...defaultSettings, baud: 9600, parity: 'none' };
const fast: LinkSettings = { ...line, baud: 38_400, parity: 'even' };

/** Runs a scan in a session, against what answers each request. */
async function scan(order: ScanOrder, answer: ConstructorParameters<typeof AnsweringLink>[1], unknown: number[] = []) {
  const clock = new VirtualClock();
  const link = new AnsweringLink(clock, answer, line);
  link.unknown = unknown;
  const told: SessionNews[] = [];
  const session = new Session({ clock, portLink: async () => link, tell: (news) => told.push(news) });
  await session.take({ kind: 'open-port', port: {}, settings: line });
  link.opened.length = 0;
  await clock.until(session.take({ kind: 'start-job', id: 1, order, confirmed: false }), 3_600_000);
  const news = told.flatMap((one) => (one.kind === 'jobs' ? one.news.map(({ news }) => news as ScanNews) : []));
  const found = news.flatMap(({ found }) => (found ? [found] : []));
  return { link, clock, told, session, news, found };
}

const units = (change: Partial<Extract<ScanOrder, { what: 'units' }>> = {}): ScanOrder => ({
  kind: 'scan',
  what: 'units',
  transport: 'rtu',
  timeout: 50,
  first: 1,
  last: 5,
  lines: [],
  ...change,
});

// Unit 1 is asked for a register. Unit 2 refuses (02), unit 4 answers with 1234.
const READ = hex('01 03 00 00 00 01 84 0A');
const TWO = hex('02 83 02 30 F1');
const FOUR = hex('04 03 02 12 34 79 33');
const twoAndFour = (request: Uint8Array) =>
  request[0] === 2 ? ([10, TWO] as const) : request[0] === 4 ? ([10, FOUR] as const) : undefined;

describe('units', () => {
  test('whose answer is doubtful are asked again', async () => {
    // Two different replies come to the first request.
    const BOTH = Uint8Array.from([...FOUR, ...hex('04 03 02 12 35 B8 F3')]);
    let asked = 0;
    const { found, link } = await scan(units({ first: 4, last: 4 }), () => {
      asked += 1;
      return [10, asked === 1 ? BOTH : FOUR];
    });
    expect(link.written).toHaveLength(2);
    expect(found).toMatchObject([{ unit: 4, outcome: 'reply', reply: FOUR }]);
  });

  test('answer, or refuse, and are found; silence is waited for no longer than the time-out', async () => {
    const { link, found, news, clock, told } = await scan(units(), twoAndFour);
    expect(link.written.map(({ bytes }) => text(bytes))).toEqual([
      '010300000001840A',
      '0203000000018439',
      '03030000000185E8',
      '040300000001845F',
      '050300000001858E',
    ]);
    expect(found).toMatchObject([
      { what: 'unit', unit: 2, outcome: 'exception', exceptionCode: 2, reply: TWO, settings: line },
      { what: 'unit', unit: 4, outcome: 'reply', reply: FOUR, settings: line },
    ]);
    expect(news.map(({ done }) => done)).toEqual([0, 1, 2, 3, 4, 5]);
    expect(news.at(-1)).toMatchObject({ total: 5, left: 0 });
    // Three silent units: 8 characters of 10 bits and the time-out each.
    expect(clock.now()).toBeGreaterThan(3 * 58);
    expect(clock.now()).toBeLessThan(3 * 70 + 2 * 40);
    expect(told.at(-1)).toEqual({ kind: 'job-ended', id: 1 });
    expect(link.opened).toEqual([]);
  });

  test('are looked for with other speeds and formats, and those of before are put back', async () => {
    const atFast = (request: Uint8Array, { baud }: LinkSettings) => (baud === 38_400 ? twoAndFour(request) : undefined);
    const { link, found, news } = await scan(units({ lines: [line, fast] }), atFast);
    expect(link.opened).toEqual([fast, line]);
    expect(link.state).toMatchObject({ kind: 'open', settings: line });
    expect(found).toMatchObject([
      { unit: 2, settings: fast },
      { unit: 4, settings: fast },
    ]);
    expect(news.at(-1)).toMatchObject({ done: 10, total: 10, left: 0 });
  });

  test('a speed that the port does not know is said, and the next is tried', async () => {
    const { link, found, news } = await scan(units({ lines: [fast, line] }), twoAndFour, [38_400]);
    expect(link.opened).toEqual([fast, line]);
    expect(found[0]).toEqual({ what: 'not-opened', settings: fast });
    expect(found.slice(1)).toMatchObject([{ unit: 2 }, { unit: 4 }]);
    expect(news.at(-1)).toMatchObject({ done: 10, total: 10 });
  });

  test('a device that answers only when the next is asked is found all the same', async () => {
    const { found } = await scan(units(), (request) => (request[0] === 4 ? [70, FOUR] : undefined));
    expect(found).toMatchObject([{ unit: 4, outcome: 'reply', reply: FOUR, late: true }]);
  });

  test('what comes broken is told', async () => {
    const { found } = await scan(units(), (request) => (request[0] === 4 ? [10, FOUR.with(3, 0x13)] : undefined));
    expect(found).toMatchObject([{ unit: 4, outcome: 'broken' }]);
  });
});

describe('a scan of several speeds', () => {
  async function begun(lines: LinkSettings[]) {
    const clock = new VirtualClock();
    const link = new AnsweringLink(clock, twoAndFour, line);
    const told: SessionNews[] = [];
    const session = new Session({ clock, portLink: async () => link, tell: (news) => told.push(news) });
    await session.take({ kind: 'open-port', port: {}, settings: line });
    link.opened.length = 0;
    const ended = session.take({ kind: 'start-job', id: 1, order: units({ lines }), confirmed: false });
    await clock.advance(100);
    return { clock, link, told, session, ended };
  }

  test('that is stopped puts the settings back', async () => {
    const { clock, link, session, ended } = await begun([fast]);
    expect(link.state).toMatchObject({ settings: fast });
    await session.take({ kind: 'stop-job', id: 1 });
    await clock.until(ended);
    expect(link.state).toMatchObject({ kind: 'open', settings: line });
    expect(link.written.length).toBeLessThan(4);
  });

  test('ends when somebody disconnects, and opens nothing', async () => {
    const { clock, link, session, ended } = await begun([fast]);
    await clock.until(session.take({ kind: 'close' }));
    await clock.until(ended);
    await clock.advance(1000);
    expect(link.state).toEqual({ kind: 'closed' });
    expect(link.opened).toEqual([fast]);
  });

  test('ends when the adapter is lost', async () => {
    const { clock, link, ended } = await begun([fast]);
    link.lose();
    await clock.until(ended);
    expect(link.state.kind).toBe('lost');
  });

  test('lets nothing else be sent', async () => {
    const { clock, told, session, ended } = await begun([fast]);
    const request = hex('11 03 00 6B 00 03 76 87');
    await session.take({ kind: 'send', id: 2, request, confirmed: false });
    expect(told.at(-1)).toEqual({ kind: 'refused', id: 2, why: 'scanning' });
    await clock.until(ended);
    void session.take({ kind: 'send', id: 3, request, confirmed: false });
    await clock.advance(3000);
    expect(told).toContainEqual(expect.objectContaining({ kind: 'result', id: 3 }));
  });
});

test('a unit scan of several speeds does not begin while something is sent', async () => {
  const clock = new VirtualClock();
  const link = new AnsweringLink(clock, () => undefined, line);
  const told: SessionNews[] = [];
  const session = new Session({ clock, portLink: async () => link, tell: (news) => told.push(news) });
  await session.take({ kind: 'open-port', port: {}, settings: line });
  void session.take({ kind: 'send', id: 1, request: hex('11 03 00 6B 00 03 76 87'), confirmed: false });
  await session.take({ kind: 'start-job', id: 2, order: units({ lines: [fast] }), confirmed: false });
  expect(told.at(-1)).toEqual({ kind: 'refused', id: 2, why: 'busy' });
});

describe('functions', () => {
  const order: ScanOrder = { kind: 'scan', what: 'functions', transport: 'rtu', timeout: 50, unit: 17 };

  test('are asked for with requests that change nothing and break no rule', () => {
    const readings = requestsOf(order).map((request) =>
      decodeFrame(request, { transport: 'rtu', direction: 'request' }),
    );
    expect(readings.map(({ functionCode }) => functionCode)).toEqual([
      0x01, 0x02, 0x03, 0x04, 0x07, 0x08, 0x0b, 0x0c, 0x11, 0x14, 0x18, 0x2b,
    ]);
    for (const reading of readings) {
      expect(mayChange(reading)).toBe(false);
      expect(reading.outcome).toEqual({ kind: 'whole' });
      expect(reading.problems.filter(({ severity }) => severity !== 'note')).toEqual([]);
    }
  });

  test('are told with what each was answered', async () => {
    const { found } = await scan(order, ([, code]) => {
      if (code === 0x03) return [5, hex('11 03 02 12 34 74 F0')];
      if (code === 0x04) return [5, hex('11 84 02 C3 04')];
      return code === 0x07 ? [5, hex('11 87 01 83 F5')] : undefined;
    });
    expect(found).toHaveLength(12);
    expect(found.slice(2, 6)).toMatchObject([
      { what: 'function', functionCode: 0x03, outcome: 'reply' },
      { what: 'function', functionCode: 0x04, outcome: 'exception', exceptionCode: 2 },
      { what: 'function', functionCode: 0x07, outcome: 'exception', exceptionCode: 1 },
      { what: 'function', functionCode: 0x08, outcome: 'silent' },
    ]);
  });
});

describe('addresses', () => {
  const order = (change: Partial<Extract<ScanOrder, { what: 'addresses' }>> = {}): ScanOrder => ({
    kind: 'scan',
    what: 'addresses',
    transport: 'rtu',
    timeout: 50,
    unit: 1,
    table: 'holding-register',
    first: 0,
    last: 99,
    most: 100,
    least: 1,
    ...change,
  });

  /** A server that has these registers, gives at most so many at once, and refuses anything else. */
  const server =
    (has: (address: number) => boolean, most = 125) =>
    (request: Uint8Array): readonly [number, Uint8Array] => {
      const { fields } = decodeFrame(request, { transport: 'rtu', direction: 'request' });
      const { startAddress, quantity } = fields as { startAddress: number; quantity: number };
      const wanted = Array.from({ length: quantity }, (_, index) => startAddress + index);
      if (quantity > most) return [1, hex('01 83 03 01 31')];
      if (!wanted.every(has)) return [1, hex('01 83 02 C0 F1')];
      return [1, crc(Uint8Array.from([1, 3, 2 * quantity, ...wanted.flatMap((one) => [one >> 8, one & 255])]))];
    };

  /** With its CRC (SL 2.5.1.2), bit by bit. */
  function crc(bytes: Uint8Array): Uint8Array {
    let register = 0xffff;
    for (const byte of bytes) {
      register ^= byte;
      for (let bit = 0; bit < 8; bit++) register = register & 1 ? (register >> 1) ^ 0xa001 : register >> 1;
    }
    return Uint8Array.from([...bytes, register & 255, register >> 8]);
  }

  const ranges = (found: readonly ScanFinding[]) =>
    found.flatMap((one) => (one.what === 'addresses' ? [[one.first, one.last, one.outcome]] : []));

  test('one request is enough where all answer', async () => {
    const { found, link, news } = await scan(
      order(),
      server(() => true),
    );
    expect(ranges(found)).toEqual([[0, 99, 'reply']]);
    expect(link.written).toHaveLength(1);
    expect(news.at(-1)).toMatchObject({ done: 100, total: 100, left: 0 });
  });

  test('a refused block is halved, and what is sure is not asked for', async () => {
    // 0 to 7 but for 6: refused, 0–3 answers, so 4–7 has the fault; 4–5 answers, so 6–7 has it; 6 is refused, 7 answers.
    const { found, link } = await scan(
      order({ last: 7 }),
      server((address) => address !== 6),
    );
    expect(ranges(found)).toEqual([
      [0, 3, 'reply'],
      [4, 5, 'reply'],
      [6, 6, 'exception'],
      [7, 7, 'reply'],
    ]);
    const asked = link.written.map(({ bytes }) => [bytes[3], bytes[5]]);
    expect(asked).toEqual([
      [0, 8],
      [0, 4],
      [4, 2],
      [6, 1],
      [7, 1],
    ]);
  });

  test('blocks are no longer than the device gives at once', async () => {
    const { found, link } = await scan(
      order({ most: 32 }),
      server(() => true, 16),
    );
    expect(ranges(found).every(([, , outcome]) => outcome === 'reply')).toBe(true);
    // 32 is refused once, for the first block.
    expect(link.written.map(({ bytes }) => bytes[5])).toEqual([32, 16, 16, 16, 16, 16, 16, 4]);
  });

  test('a block is not halved below the least', async () => {
    const { found, link } = await scan(
      order({ least: 25 }),
      server(() => false),
    );
    expect(ranges(found)).toEqual([
      [0, 24, 'exception'],
      [25, 49, 'exception'],
      [50, 74, 'exception'],
      [75, 99, 'exception'],
    ]);
    expect(link.written).toHaveLength(7);
  });

  test('a silent block is told as such, and not halved', async () => {
    const { found, link } = await scan(order(), () => undefined);
    expect(ranges(found)).toEqual([[0, 99, 'silent']]);
    expect(link.written).toHaveLength(1);
  });

  test('whatever a device has is found, each address once and in order', async () => {
    const address = fc.integer({ min: 0, max: 63 });
    const number = fc.integer({ min: 1, max: 64 });
    await fc.assert(
      fc.asyncProperty(fc.uniqueArray(address), number, number, async (lacking, most, atOnce) => {
        const answered: [number, string][] = [];
        await searchAddresses({
          first: 0,
          last: 63,
          most,
          least: 1,
          ask: async ({ address, quantity }) => {
            const lacks = lacking.some((one) => one >= address && one < address + quantity);
            const exceptionCode = quantity > atOnce ? 3 : lacks ? 2 : undefined;
            const common = { request: READ, reply: READ };
            return exceptionCode === undefined
              ? { outcome: 'reply', ...common }
              : { outcome: 'exception', exceptionCode, ...common };
          },
          tell: ({ address, quantity }, { outcome }) => {
            for (let one = address; one < address + quantity; one++) answered.push([one, outcome]);
          },
        });
        expect(answered).toEqual(
          Array.from({ length: 64 }, (_, one) => [one, lacking.includes(one) ? 'exception' : 'reply']),
        );
      }),
    );
  });
});

describe('findings', () => {
  const answer = { outcome: 'reply', request: READ, reply: FOUR } as const;
  const added = (...all: ScanFinding[]) => {
    const found: ScanFinding[] = [];
    for (const one of all) addFinding(found, one);
    return found;
  };

  test('neighbours that were answered alike are one', () => {
    const block = (first: number, last: number, exceptionCode?: number): ScanFinding => ({
      what: 'addresses',
      first,
      last,
      ...answer,
      ...(exceptionCode !== undefined && { outcome: 'exception', exceptionCode }),
    });
    const found = added(block(0, 3), block(4, 5), block(6, 6, 2), block(7, 7), block(9, 9));
    expect(found).toEqual([block(0, 5), block(6, 6, 2), block(7, 7), block(9, 9)]);
    expect(countFindings(found)).toBe(8);
  });

  test('what is told again takes the place of what was told before', () => {
    const silent: ScanFinding = { what: 'function', functionCode: 3, outcome: 'silent', request: READ };
    const late: ScanFinding = { what: 'function', functionCode: 3, ...answer, late: true };
    expect(added(silent, { ...silent, functionCode: 4 }, late)).toEqual([late, { ...silent, functionCode: 4 }]);
  });

  test('a unit at two speeds is two findings of one unit', () => {
    const at = (settings: LinkSettings): ScanFinding => ({ what: 'unit', unit: 4, settings, ...answer });
    const found = added(at(line), at(fast), { what: 'not-opened', settings: line });
    expect(found).toHaveLength(3);
    expect(countFindings(found)).toBe(1);
  });

  test('only exception 01 says that a function is not there', () => {
    const refused = { outcome: 'exception', request: READ } as const;
    expect(supports({ ...refused, exceptionCode: 1 })).toBe('no');
    expect(supports({ ...refused, exceptionCode: 2 })).toBe('yes');
    expect(supports(answer)).toBe('yes');
    expect(supports({ outcome: 'silent', request: READ })).toBe('silent');
    expect(supports({ outcome: 'broken', request: READ })).toBe('unsure');
  });
});

test('the estimate is from the time-out and the speed', () => {
  // 8 characters of 10 bits at 9600 baud are 8.33 ms, and 3.5 are 3.65 ms.
  const estimate = estimateScan(units({ last: 247, timeout: 100 }), line, defaultRules);
  expect(estimate.requests).toBe(247);
  expect(estimate.time).toBeCloseTo(247 * (8.333 + 100 + 3.646), 0);
  const two = estimateScan(units({ last: 247, timeout: 100, lines: [line, line] }), line, defaultRules);
  expect(two.time).toBeCloseTo(2 * estimate.time, 3);
});
