import { describe, expect, test } from 'vitest';
import { namedValues } from '../../../../src/devices/index.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';

import { deviceOfLink } from '../../../../src/workbench/index.ts';
import links from '../../../vectors/links.json' with { type: 'json' };

const framed = (link: string) => {
  const reading = readLink(link)!;
  const { frame } = evaluate(reading.draft);
  return {
    ...reading,
    bytes:
      frame &&
      Buffer.from(frame.bytes)
        .toString('hex')
        .toUpperCase()
        .replace(/..(?=.)/g, '$& '),
  };
};

/** Links as they were written by each version of their form; they open the same frames for ever. */
describe('a link that was kept', () => {
  test.each(links)('$link of version 1 opens its frame', ({ link, bytes }) => {
    expect(framed(link)).toMatchObject({ unknown: [], bytes });
    expect(framed(link).newer).toBeUndefined();
  });

  test('of version 2 opens its frame, with what was typed and the device it was typed for', () => {
    const link =
      '#rtu/request?v=2&unitId=6&functionCode=6&address=HR684&value=4096&typed.address=P0683&typed.value=30+Hz&device=weg-drive';
    const { draft, unknown, bytes } = framed(link);
    expect(unknown).toEqual([]);
    expect(bytes).toBe('06 06 02 AB 10 00 F5 E5');
    expect(draft.typed).toEqual({
      address: { typed: 'P0683', text: 'HR684' },
      value: { typed: '30 Hz', text: '4096' },
    });
    expect(draft.device).toBe('weg-drive');
  });

  test('of version 3 opens its frame, with the request as it was typed, the tab and the line', () => {
    const link =
      '#rtu/reply?v=3&unitId=6&functionCode=3&registers=4096&answering=06+03+02+AB+00+01+F4+0D' +
      '&partner=rtu%2Frequest%3Fv%3D2%26unitId%3D6%26functionCode%3D3%26startAddress%3DHR684%26quantity%3D1' +
      '%26typed.startAddress%3DP0683%26device%3Dweg-drive&tab=values&line=9600-8N1';
    const { draft, context, unknown, bytes } = framed(link);
    expect(unknown).toEqual([]);
    expect(bytes).toBe('06 03 02 10 00 00 44');
    expect(draft.partner?.typed).toEqual({ startAddress: { typed: 'P0683', text: 'HR684' } });
    expect(context).toEqual({ tab: 'values', line: { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 } });
  });

  test('of version 3 names the device beside anything, and what it has that nobody knows is told', () => {
    const link = '#rtu/request?v=3&unitId=6&functionCode=6&address=0x02AB&value=4096&device=weg-drive&tab=x&line=fast';
    const { draft, context, unknown } = framed(link);
    expect(draft.device).toBe('weg-drive');
    expect(context).toBeUndefined();
    expect(unknown).toEqual(['tab', 'line']);
  });

  test('of version 4 opens its frame, with a device of its own', () => {
    const { draft, context, unknown, newer, bytes } = framed(
      '#rtu/request?v=4&unitId=6&functionCode=3&startAddress=0&quantity=2&device=own~1a2b' +
        '&profile=%5B1%2C%22Pumpe%22%2C2%2C0%2C%5B%5D%2C%5B%5B0%2C%22Drehzahl%22%2C3%2C%22f32%22%5D%5D%5D',
    );
    expect({ unknown, newer, bytes }).toEqual({ unknown: [], newer: undefined, bytes: '06 03 00 00 00 02 C5 BC' });
    expect(draft.device).toBe('own~1a2b');
    expect(deviceOfLink({ id: 'own~1a2b', text: context?.profile ?? '' })).toMatchObject({
      name: 'Pumpe',
      registers: [{ name: 'Drehzahl', type: 'f32' }],
    });
  });

  test('of version 4 means its factors as they were meant: in version 1 of a device, raw was value × factor + offset', () => {
    const read = (profile: string) => {
      const link = `#rtu/request?v=4&unitId=6&functionCode=3&startAddress=0&quantity=1&device=own~1&profile=${profile}`;
      const { context, bytes } = framed(link);
      const device = deviceOfLink({ id: 'own~1', text: context?.profile ?? '' });
      return { bytes, scaled: device && namedValues(device, 'holding-register', 0, [615])[0]?.scaled };
    };
    const frame = { bytes: '06 03 00 00 00 01 85 BD', scaled: 21.5 };
    expect(read('%5B1%2C%22T%22%2C0%2C0%2C%5B%5D%2C%5B%5B0%2C%22T%22%2C3%2C0%2C%22C%22%2C10%2C400%5D%5D%5D')).toEqual(
      frame,
    );
    expect(read('%5B2%2C%22T%22%2C0%2C0%2C%5B%5D%2C%5B%5B0%2C%22T%22%2C3%2C0%2C%22C%22%2C0.1%2C-40%5D%5D%5D')).toEqual(
      frame,
    );
  });

  test('of version 5 opens its frame, with the program that it shows', () => {
    const { context, unknown, newer, bytes } = framed(
      '#rtu/request?v=5&unitId=6&functionCode=6&address=683&value=4096&tab=program&program=c.check',
    );
    expect({ unknown, newer, bytes }).toEqual({ unknown: [], newer: undefined, bytes: '06 06 02 AB 10 00 F5 E5' });
    expect(context).toEqual({ tab: 'program', program: 'c.check' });
  });

  test.each(['', 'v=2&', 'v=3&'])('loses nothing silently that a newer version added (%s)', (version) => {
    const { draft, context, unknown } = framed(
      `#rtu/reply?${version}unitId=6&functionCode=3&registers=4096&tab=values&line=9600-8N1&device=weg-drive` +
        '&partner=rtu%2Frequest%3FunitId%3D6%26functionCode%3D3',
    );
    expect(context).toEqual({ tab: 'values', line: { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 } });
    expect(draft).toMatchObject({ device: 'weg-drive', partner: { kind: 'request' } });
    expect(unknown).toEqual([]);
  });

  test.each(['', 'v=2&'])('has what was typed, whatever version it says (%s)', (version) => {
    const { draft, unknown } = framed(
      `#pdu/request?${version}functionCode=3&startAddress=HR684&typed.startAddress=P0683&device=weg-drive`,
    );
    expect(unknown).toEqual([]);
    expect(draft).toEqual({
      transport: 'pdu',
      kind: 'request',
      texts: { functionCode: '3', startAddress: 'HR684' },
      force: {},
      answering: '',
      typed: { startAddress: { typed: 'P0683', text: 'HR684' } },
      device: 'weg-drive',
    });
  });

  test('of a version that is not there yet is read as far as it is known, and said to be so', () => {
    expect(framed('#rtu/request?v=6&unitId=6&functionCode=6&address=0x02AB&value=4096&colour=red&x.y=1')).toMatchObject(
      {
        newer: 6,
        unknown: ['colour', 'x.y'],
        bytes: '06 06 02 AB 10 00 F5 E5',
      },
    );
    expect(framed('#rtu/request?v=2&unitId=6').newer).toBeUndefined();
  });
});
