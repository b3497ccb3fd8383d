import { describe, expect, it } from 'vitest';
import { toolAsked as askedOn } from '../../../../src/workbench/reading/input-tools.ts';
import { meant } from './meant.ts';

/** The default of the specification (SL 2.5.1). */
const LINE = { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 } as const;
const toolAsked = (text: string) => askedOn(text, LINE);

describe('a checksum', () => {
  // SL App. B: the CRC of 02 07 is 0x1241, sent as 41 12. That of 01 03 00 00 00 0A is sent as C5 CD. The LRC is the two's
  // complement of the sum: 0x0E gives 0xF2, and 0x09 gives 0xF7.
  const CRC = { size: 2, crc: 0x1241 };
  it.each([
    ['crc 02 07', CRC],
    ['crc 0207', CRC],
    ['CRC of 0x02, 0x07?', CRC],
    ['crc16 02 07', CRC],
    ['modbus crc: 02 07', CRC],
    ['crc-16/modbus 02 07', CRC],
    ['what is the crc of 02 07', CRC],
    ['02 07 crc', CRC],
    ['crc 2 7', CRC],
    ['lrc 02 07', { size: 2, lrc: 0xf7 }],
    ['checksum 01 03 00 00 00 0A', { size: 6, crc: 0xcdc5, lrc: 0xf2 }],
    ['01 03 00 00 00 0A checksum?', { size: 6, crc: 0xcdc5, lrc: 0xf2 }],
    ['lrc 01 03 00 00 00 0A', { size: 6, lrc: 0xf2 }],
    ['crc', { size: 0 }],
    ['checksum?', { size: 0 }],
  ])('%s', (text, values) => {
    expect(toolAsked(text)).toEqual({ tool: 'checksum', ...values, parts: expect.anything() });
  });

  it('opens the Checksum view with its bytes, of any other algorithm with a search', () => {
    expect(toolAsked('crc 02 07')).toMatchObject({ parts: { bytes: '02 07', algorithm: '', search: '' } });
    expect(toolAsked('lrc 02 07')).toMatchObject({ parts: { bytes: '02 07', algorithm: 'LRC' } });
    for (const text of ['crc32 02 07', 'CRC-32: 02 07'])
      expect(toolAsked(text)).toEqual({
        tool: 'checksum',
        size: 2,
        parts: { bytes: '02 07', algorithm: '', search: 'crc-32' },
      });
    expect(toolAsked('xor 02 07')).toMatchObject({ parts: { search: 'xor' } });
  });

  it.each(['crc error', 'crc error 02 07', 'crc 02 xy 07', 'the crc of 02 07 is wrong', '02 07', 'crc\n02 07'])(
    'is not what %s asks',
    (text) => {
      expect(toolAsked(text)).toBeUndefined();
    },
  );

  it('gives way to a frame that is whole', () => {
    // The CRC of these six bytes is C5 CD.
    expect(meant('crc 01 03 00 00 00 0A C5 CD').kind).toBe('frames');
    expect(meant('crc 01 03 00 00 00 0A C5 CE').kind).toBe('tool');
    expect(meant('crc 01 10 00 01 00 02 04 00 0A 01 02').kind).toBe('tool');
  });
});

describe('the times of a line', () => {
  const EIGHT_NONE = { dataBits: 8, parity: 'none', stopBits: 1 } as const;
  it.each([
    ['t3.5 9600 8N1', { baud: 9600, ...EIGHT_NONE }],
    ['9600 8N1', { baud: 9600, ...EIGHT_NONE }],
    ['9600,8,n,1', { baud: 9600, ...EIGHT_NONE }],
    ['9600-8-N-1', { baud: 9600, ...EIGHT_NONE }],
    ['9600/8N1', { baud: 9600, ...EIGHT_NONE }],
    ['8O2 t1.5', { dataBits: 8, parity: 'odd', stopBits: 2 }],
    ['8N1', EIGHT_NONE],
    ['19200 8E1', { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 }],
    ['baud 9600', { baud: 9600 }],
    ['baudrate: 9600', { baud: 9600 }],
    ['9600 baud', { baud: 9600 }],
    ['9600 bps', { baud: 9600 }],
    ['19.2k baud', { baud: 19_200 }],
    ['line speed 115200', { baud: 115_200 }],
    ['T3.5 at 115200 baud', { baud: 115_200 }],
    ['parity even', { parity: 'even' }],
    ['no parity', { parity: 'none' }],
    ['even parity 2 stop bits', { parity: 'even', stopBits: 2 }],
    ['7 data bits', { dataBits: 7 }],
    ['t1.5', {}],
    ['silent interval', {}],
    ['what is the character time at 9600 8N1?', { baud: 9600, ...EIGHT_NONE }],
  ])('%s', (text, line) => {
    expect(meant(text)).toMatchObject({ kind: 'tool', tool: { tool: 'timing', line: { ...LINE, ...line } } });
  });

  it.each([
    ['timeout 500 ms', { timeout: '500 ms' }],
    ['response time-out: 1 s', { timeout: '1 s' }],
    ['turnaround 100 ms', { turnaround: '100 ms' }],
    ['gap 2ms 9600 baud', { gap: '2ms' }],
    ['timeout 1000', { timeout: '1000' }],
    ['turnaround: 100', { turnaround: '100' }],
    ['gap 9600 8N1', { baud: '9600', format: '8N1' }],
    ['gap 9600 baud', { baud: '9600' }],
    ['t1.5 gap 1,5 characters', { gap: '1,5 characters' }],
  ])('%s has a time of an exchange', (text, texts) => {
    expect(meant(text)).toMatchObject({ kind: 'tool', tool: { tool: 'timing', parts: texts } });
  });

  it.each([
    ['baud 30', '30'],
    ['baud rate 5000000', '5000000'],
    ['parity 2', '2'],
    ['3 stop bits', '3'],
  ])('%s says a number that no line has', (text, wrong) => {
    expect(meant(text)).toMatchObject({ kind: 'tool', tool: { tool: 'timing', wrong } });
  });

  it.each([
    '9600',
    '8E1',
    '30 s',
    'parity error',
    'the parity of unit 5 is wrong',
    '06 06 02 AB 10 00',
    'speed is P0683',
    'speed 1500',
  ])('is not what %s asks', (text) => {
    expect(toolAsked(text)).toBeUndefined();
  });

  it('are those of its characters, and fixed above 19200 baud (SL 2.5.1.1)', () => {
    const times = (text: string) => {
      const tool = toolAsked(text);
      return tool?.tool === 'timing'
        ? [tool.character, tool.t15, tool.t35].map((time) => Math.round(10 * time) / 10)
        : [];
    };
    // Ten bits at 9600 bits a second; eleven at 115200.
    expect(times('t3.5 9600 8N1')).toEqual([1041.7, 1562.5, 3645.8]);
    expect(times('t3.5 115200 baud')).toEqual([95.5, 750, 1750]);
    expect(toolAsked('9600 8N1 gap 2 ms')).toMatchObject({ parts: { baud: '9600', format: '8N1', gap: '2 ms' } });
  });
});

describe('the code of an exception', () => {
  it.each([
    ['exception 02', 2],
    ['Exception code 2', 2],
    ['exception 0x0B', 11],
    ['exception 0B', 11],
    ['exception 11', 11],
    ['error code 4', 4],
    ['what is exception 2?', 2],
    ['what does exception 2 mean?', 2],
    ['exception 99', 99],
  ])('%s', (text, code) => {
    expect(meant(text)).toEqual({ kind: 'tool', tool: { tool: 'exception', code } });
  });

  it.each(['exception', 'exception 0', 'exception 300', 'read exception status'])('is not what %s asks', (text) => {
    expect(toolAsked(text)).toBeUndefined();
  });
});
