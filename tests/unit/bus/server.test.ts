import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { type ServerParts, sourceServers, VirtualServer } from '../../../src/bus/index.ts';
import { crc16, decodeFrame, encodeFrame, functionCodes, toHex } from '../../../src/modbus/index.ts';
import { anyBytes, legalFrame } from '../modbus/arbitraries.ts';
import { hex } from '../modbus/frames.ts';
import { frames } from '../modbus/vectors.ts';

const UNIT = 0x11;

/** Puts unit and CRC around a PDU, low byte first. */
function rtu(pdu: string, unit = UNIT): Uint8Array {
  const body = hex(`${unit.toString(16).padStart(2, '0')}${pdu}`);
  const crc = crc16(body);
  return Uint8Array.from([...body, crc & 0xff, crc >> 8]);
}

/** The PDU that a device answers to a PDU; `undefined` where it says nothing. */
function answer(server: VirtualServer, pdu: string): string | undefined {
  const heard = server.hear(rtu(pdu), 'rtu');
  if (heard.does === 'nothing') return undefined;
  expect(crc16(heard.reply), 'the CRC of the reply').toBe(0);
  expect(heard.reply[0]).toBe(UNIT);
  return toHex(heard.reply, 1, heard.reply.length - 2);
}

const whole = [{ from: 0, count: 0x600, writable: true }];
const bitsOf = (...bytes: number[]) =>
  bytes.flatMap((byte) => Array.from({ length: 8 }, (_, bit) => (byte >> bit) & 1));

function device(parts: Partial<ServerParts> = {}): VirtualServer {
  const server = new VirtualServer({
    name: 'device',
    unit: UNIT,
    tables: { coil: whole, 'discrete-input': whole, 'holding-register': whole, 'input-register': whole },
    ...parts,
  });
  const { tables } = server;
  // The values of the examples of AP 6.1 to 6.18.
  tables.coil.write(0x13, bitsOf(0xcd, 0x6b, 0x05));
  tables['discrete-input'].write(0xc4, bitsOf(0xac, 0xdb, 0x35));
  tables['holding-register'].write(0x6b, [0x022b, 0x0000, 0x0064]);
  tables['input-register'].write(0x08, [0x000a]);
  tables['holding-register'].write(0x03, [0x00fe, 0x0acd, 0x0001, 0x0003, 0x000d, 0x00ff]);
  return server;
}

/** What it is, the PDU of the request, the PDU of the reply, and what the device is made of. */
type Example = readonly [what: string, request: string, reply: string, parts?: Partial<ServerParts>];

const named = (examples: readonly Example[]) =>
  examples.map(([what, request, reply, parts = {}]) => ({ what, request, reply, parts }));

describe('the examples of the specification', () => {
  const file4 = [0, 0x0dfe, 0x0020];
  const file3 = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0x33cd, 0x0040];
  const objects = { 0: 'Company identification', 1: 'Product code XX', 2: 'V2.11' };
  const examples: readonly Example[] = [
    ['AP 6.1', '01 0013 0013', '01 03 CD 6B 05'],
    ['AP 6.2', '02 00C4 0016', '02 03 AC DB 35'],
    ['AP 6.3', '03 006B 0003', '03 06 022B 0000 0064'],
    ['AP 6.4', '04 0008 0001', '04 02 000A'],
    ['AP 6.5', '05 00AC FF00', '05 00AC FF00'],
    ['AP 6.6', '06 0001 0003', '06 0001 0003'],
    ['AP 6.7', '07', '07 6D', { exceptionStatus: 0x6d }],
    ['AP 6.8.2', '08 0000 A537', '08 0000 A537'],
    ['AP 6.11', '0F 0013 000A 02 CD 01', '0F 0013 000A'],
    ['AP 6.12', '10 0001 0002 04 000A 0102', '10 0001 0002'],
    ['PI, 17', '11', '11 09 09 FF 04 00 00 20 00 00 00', { serverId: '09FF04000020000000' }],
    [
      'AP 6.14',
      '14 0E 06 0004 0001 0002 06 0003 0009 0002',
      '14 0C 05 06 0DFE 0020 05 06 33CD 0040',
      { files: { 4: file4, 3: file3 } },
    ],
    [
      'AP 6.15',
      '15 0D 06 0004 0007 0003 06AF 04BE 100D',
      '15 0D 06 0004 0007 0003 06AF 04BE 100D',
      { files: { 4: Array.from({ length: 10 }, () => 0) } },
    ],
    ['AP 6.16', '16 0004 00F2 0025', '16 0004 00F2 0025'],
    ['AP 6.17', '17 0003 0006 000E 0003 06 00FF 00FF 00FF', '17 0C 00FE 0ACD 0001 0003 000D 00FF'],
    ['AP 6.18', '18 04DE', '18 0006 0002 01B8 1284', { fifos: { 1246: [0x01b8, 0x1284] } }],
    [
      'AP 6.21',
      '2B 0E 01 00',
      // The lengths that the text has; the specification prints 0D for the 15 characters of the second.
      `2B 0E 01 01 00 00 03 00 16 ${toHex(Buffer.from(objects[0]))} 01 0F ${toHex(Buffer.from(objects[1]))} 02 05 ${toHex(Buffer.from(objects[2]))}`,
      { objects, conformityLevel: 0x01 },
    ],
  ];
  test.each(named(examples))('$what: $request', ({ request, reply, parts }) => {
    expect(answer(device(parts), request)).toBe(reply.replaceAll(' ', ''));
  });

  test('AP 6.9, AP 6.10: the counter and the log of events', () => {
    const server = device();
    server.busy = true;
    server.counters.eventCount = 0x0108;
    expect(answer(server, '0B')).toBe('0BFFFF0108');
    expect(answer(server, '0B'), 'asking for it does not count').toBe('0BFFFF0108');
    server.busy = false;
    // The request that asks for the log is a message too.
    server.counters.counts.busMessages = 0x0120;
    server.counters.events = [0x20, 0x00];
    expect(answer(server, '0C')).toBe('0C080000010801212000');
  });

  test('what was written stands there', () => {
    const server = device({ files: { 4: Array.from({ length: 10 }, () => 0) } });
    const { coil, 'holding-register': holding } = server.tables;
    answer(server, '05 00AC FF00');
    answer(server, '06 0001 0003');
    answer(server, '0F 0013 000A 02 CD 01');
    answer(server, '10 0010 0002 04 000A 0102');
    holding.write(4, [0x0012]);
    answer(server, '16 0004 00F2 0025');
    answer(server, '17 0020 0001 0020 0001 02 00FF');
    answer(server, '15 0D 06 0004 0007 0003 06AF 04BE 100D');
    expect(coil.read(0xac, 1)).toEqual([1]);
    expect(holding.read(1, 1)).toEqual([3]);
    expect(coil.read(0x13, 11)).toEqual([1, 0, 1, 1, 0, 0, 1, 1, 1, 0, 0]);
    expect(holding.read(0x10, 2)).toEqual([0x000a, 0x0102]);
    expect(holding.read(4, 1), 'AP 6.16: 12 becomes 17').toEqual([0x0017]);
    expect(holding.read(0x20, 1)).toEqual([0x00ff]);
    expect(Array.from(server.files.get(4) ?? [])).toEqual([0, 0, 0, 0, 0, 0, 0, 0x06af, 0x04be, 0x100d]);
    expect(answer(server, '17 0020 0001 0020 0001 02 1234'), 'the write comes before the read').toBe('17021234');
  });

  test('an identification that is too long comes in parts', () => {
    const server = device({ objects: { 0: 'A'.repeat(200), 1: 'B'.repeat(100), 2: 'C' } });
    const first = answer(server, '2B 0E 01 00') ?? '';
    expect(first.slice(0, 14)).toBe('2B0E0183FF0101');
    const second = answer(server, '2B 0E 01 01') ?? '';
    expect(second.slice(0, 14)).toBe('2B0E0183000002');
    expect(answer(server, '2B 0E 04 02')).toBe('2B0E0483000001020143');
    expect(answer(server, '2B 0E 04 03')).toBe('AB02');
    expect(answer(server, '2B 0E 01 77')?.slice(0, 14), 'from the start again').toBe('2B0E0183FF0101');
  });
});

describe('exceptions, in the order of the state diagrams: 01, 03, 02', () => {
  const refused: readonly Example[] = [
    ['a function that is none', '41 00', 'C101'],
    ['a function it does not have', '02 0000 0001', '8201', { functions: [1, 3] }],
    ['the same with a wrong quantity', '02 0000 0000', '8201', { functions: [1, 3] }],
    ['quantity 0', '01 0000 0000', '8103'],
    ['2001 coils', '01 0000 07D1', '8103'],
    ['126 registers', '03 0000 007E', '8303'],
    ['126 registers of an address it does not have: value before address', '03 FFFF 007E', '8303'],
    ['beyond the last address', '03 FFFF 0002', '8302'],
    ['an address it does not have', '04 0600 0001', '8402'],
    ['the last address it has, and one more', '03 05FF 0002', '8302'],
    ['coil value 0001', '05 0000 0001', '8503'],
    ['coil value 0001 at an address it does not have', '05 0600 0001', '8503'],
    ['a coil it does not have', '05 0600 FF00', '8502'],
    ['a register it does not have', '06 0600 0000', '8602'],
    ['a byte count that is not that of the quantity', '0F 0000 000A 01 CD', '8F03'],
    ['a byte count that is not that of the registers', '10 0000 0002 02 0001', '9003'],
    ['a request that is cut off before its CRC', '03 0000', '8303'],
    ['a request that is too long', '06 0001 0003 00', '8603'],
    ['a sub-function that is reserved', '08 0005 0000', '8801'],
    ['a sub-function with data it does not take', '08 000B 0001', '8803'],
    ['file 0', '14 07 06 0000 0000 0001', '9402'],
    ['a file it does not have', '14 07 06 0001 0000 0001', '9402'],
    ['a byte count that makes no groups', '14 06 06 0001 0000 00', '9403'],
    ['a mask for a register it does not have', '16 0600 0000 0000', '9602'],
    ['more to read than there is, though the write would do', '17 05FF 0002 0000 0001 02 0000', '9702'],
    ['a queue it does not have', '18 0000', '9802'],
    ['a queue that is too long', '18 0001', '9803', { fifos: { 1: Array.from({ length: 32 }, () => 1) } }],
    ['CANopen', '2B 0D 00', 'AB01'],
    ['an MEI type that is reserved', '2B 05', 'AB01'],
    ['a read device id code that is none', '2B 0E 05 00', 'AB03', { objects: { 0: 'A' } }],
  ];
  test.each(named(refused))('$what', ({ request, reply, parts }) => {
    expect(answer(device(parts), request)).toBe(reply);
  });

  test('what may not be written is refused with 02, and stays', () => {
    const server = device({ tables: { 'holding-register': [{ from: 0, count: 10, writable: false }] } });
    expect(answer(server, '06 0001 1234')).toBe('8602');
    expect(answer(server, '03 0001 0001')).toBe('03020000');
  });

  test('devices that depart from the specification do so', () => {
    const traits = ['any-value-is-on', 'byte-count-plus-one'] as const;
    const server = device({ traits });
    expect(answer(server, '05 0000 0100')).toBe('0500000100');
    expect(server.tables.coil.read(0, 1)).toEqual([1]);
    expect(answer(server, '05 0000 0001')).toBe('0500000001');
    expect(server.tables.coil.read(0, 1)).toEqual([0]);
    server.tables.coil.write(8, [1]);
    expect(answer(server, '0F 0000 0008 02 FF 00')).toBe('0F00000008');
    expect(server.tables.coil.read(0, 9)).toEqual([1, 1, 1, 1, 1, 1, 1, 1, 1]);
    expect(answer(server, '0F 0000 0008 03 FF 00 00')).toBe('8F03');
  });
});

describe('on the line', () => {
  test('it is silent for other units, broadcasts and broken frames, and counts them', () => {
    const server = device();
    expect(server.hear(rtu('03 0000 0001', 5), 'rtu')).toEqual({ does: 'nothing', why: 'other-unit' });
    expect(server.hear(rtu('06 0001 1234', 0), 'rtu')).toEqual({ does: 'nothing', why: 'broadcast' });
    expect(server.tables['holding-register'].read(1, 1)).toEqual([0x1234]);
    expect(server.hear(rtu('16 0001 0000 5678', 0), 'rtu')).toEqual({ does: 'nothing', why: 'broadcast' });
    expect(server.tables['holding-register'].read(1, 1), '16 has no agreed broadcast').toEqual([0x1234]);
    expect(server.hear(hex('11 03 00 6B 00 03 76 88'), 'rtu')).toEqual({ does: 'nothing', why: 'broken-frame' });
    answer(server, '03 FFFF 0002');
    // Four requests were whole, three of them for this device, two without a reply; this is the next.
    expect(answer(server, '08 000B 0000')).toBe('08000B0005');
    expect(answer(server, '08 000C 0000')).toBe('08000C0001');
    expect(answer(server, '08 000D 0000')).toBe('08000D0001');
    expect(answer(server, '08 000E 0000')).toBe('08000E0007');
    expect(answer(server, '08 000F 0000')).toBe('08000F0002');
    expect(answer(server, '08 000A 0000')).toBe('08000A0000');
    expect(answer(server, '08 000C 0000')).toBe('08000C0000');
  });

  test('in listen only mode it obeys the restart alone, without a reply', () => {
    const server = device();
    expect(server.hear(rtu('08 0004 0000'), 'rtu')).toEqual({ does: 'nothing', why: 'no-reply' });
    expect(server.hear(rtu('06 0001 1234'), 'rtu')).toEqual({ does: 'nothing', why: 'listen-only' });
    expect(server.tables['holding-register'].read(1, 1)).toEqual([0]);
    expect(server.hear(rtu('08 0001 FF00'), 'rtu')).toEqual({ does: 'nothing', why: 'listen-only' });
    expect(answer(server, '08 0001 0000')).toBe('0800010000');
  });

  test('ASCII is answered in ASCII', () => {
    const heard = device().hear(new TextEncoder().encode(':1103006B00037E\r\n'), 'ascii');
    const reply = heard.does === 'answer' ? new TextDecoder().decode(heard.reply) : '';
    expect(reply).toBe(':110306022B0000006455\r\n');
  });
});

describe('any request', () => {
  const everything = () => sourceServers().find(({ unit }) => unit === 17)!;

  test('of any bytes never makes a device throw', () => {
    const server = everything();
    fc.assert(
      fc.property(anyBytes, fc.constantFrom('rtu' as const, 'ascii' as const), (bytes, transport) => {
        server.hear(bytes, transport);
        server.hear(rtu(toHex(bytes)), transport);
      }),
    );
  });

  test('that is legal gets a reply that fits it, or an exception, or a silence that the specification asks for', () => {
    const server = everything();
    fc.assert(
      fc.property(
        fc.constantFrom(...functionCodes.map(({ code }) => code)).chain((code) => legalFrame(code, 'rtu', 'request')),
        (input) => {
          const request = encodeFrame({ ...input, unitId: UNIT });
          const heard = server.hear(request, 'rtu');
          if (heard.does === 'nothing') {
            expect(['no-reply', 'listen-only']).toContain(heard.why);
            server.hear(rtu('08 0001 0000'), 'rtu');
            return;
          }
          const { outcome, problems } = decodeFrame(heard.reply, { transport: 'rtu', direction: 'response', request });
          expect(outcome).toEqual({ kind: 'whole' });
          expect(problems.filter(({ severity }) => severity === 'error')).toEqual([]);
        },
      ),
    );
  });

  test('of the published frames is answered without a throw', () => {
    const server = everything();
    for (const { hex: text, transport, direction } of frames) {
      if (direction !== 'request' || (transport !== 'rtu' && transport !== 'ascii')) continue;
      server.unit = transport === 'rtu' ? hex(text)[0]! : UNIT;
      expect(['answer', 'nothing']).toContain(server.hear(hex(text), transport).does);
    }
  });
});
