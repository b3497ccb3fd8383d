import { describe, expect, it } from 'vitest';
import { type LogLine, lineKinds } from '../../../../src/bus/log/line.ts';
import { fromHex } from '../../../../src/modbus/index.ts';
import {
  isLineTrouble,
  LineSearch,
  type LineWords,
  type LogFilter,
  lineMeaning,
  lineReading,
} from '../../../../src/workbench/bus/log-lines.ts';

// Unit 17, three registers from 107 on (AP 6.3), and the reply.
const READ = '1103006B00037687';
const THREE = '110306AE415652434049AD';
const REFUSAL = '118302C134';

const line = (number: number, kind: LogLine['kind'], hex: string, change: Partial<LogLine> = {}): LogLine => ({
  number,
  time: 0,
  direction: kind === 'request' ? 'sent' : 'received',
  transport: 'rtu',
  kind,
  hex,
  ...change,
});

const words: LineWords = {
  kinds: {
    request: 'Request',
    reply: 'Reply',
    exception: 'Exception',
    broken: 'Broken',
    echo: 'Echo',
    late: 'Late',
    copy: 'Copy',
    other: 'Other',
    noise: 'Noise',
    heard: 'Heard',
  },
  noMeaning: (count) => `${count} bytes of nothing`,
  frame: ({ functionCode, direction }, size) => `${direction} ${functionCode} of ${size}`,
};

const LOG = [
  line(1, 'request', READ, { verdict: 'good' }),
  line(2, 'reply', THREE, { answers: 1 }),
  line(3, 'request', READ, { verdict: 'refused' }),
  line(4, 'exception', REFUSAL, { answers: 3 }),
  line(5, 'noise', 'FF00'),
  line(6, 'request', READ, { verdict: 'silent' }),
  // A scan asks whether somebody is there.
  line(7, 'request', READ, { verdict: 'absent' }),
];

const shown = (filter: LogFilter, search = '') =>
  new LineSearch(filter, search, words).shown(LOG).map(({ number }) => number);

describe('the lines that are shown', () => {
  it('are all, or those with frames, or those with which something is wrong', () => {
    expect(new LineSearch('all', '  ', words).shown(LOG)).toBe(LOG);
    expect(shown('frames')).toEqual([1, 2, 3, 4, 6, 7]);
    expect(shown('troubles')).toEqual([3, 4, 5, 6]);
  });

  it('are found by bytes in any notation, and by words of the kind and the meaning', () => {
    for (const search of ['AE 41', 'ae41', '0xAE, 0x41', '0xae41']) expect(shown('all', search)).toEqual([2]);
    expect(shown('all', 'EXCEPTION')).toEqual([4]);
    expect(shown('all', 'of nothing')).toEqual([5]);
    expect(shown('all', 'request 3')).toEqual([1, 3, 6, 7]);
    expect(shown('troubles', 'request 3')).toEqual([3, 6]);
    expect(shown('all', 'zebra')).toEqual([]);
  });

  it('are looked at once, however often lines are added', () => {
    const read: number[] = [];
    const counting: LineWords = { ...words, frame: (_, size) => `${read.push(size)} zebras` };
    const search = new LineSearch('frames', 'zebra', counting);
    expect(search.shown(LOG.slice(0, 2))).toHaveLength(2);
    expect(search.shown(LOG.slice(1, 4)).map(({ number }) => number)).toEqual([2, 3, 4]);
    expect(read).toHaveLength(4);
  });
});

describe('something is wrong', () => {
  it('with what was not asked for or came too late, and with a request that was not answered well', () => {
    const troubled = (change: Partial<LogLine>) =>
      lineKinds.filter((kind) => isLineTrouble(line(1, kind, READ, change)));
    expect(troubled({})).toEqual(expect.arrayContaining(['exception', 'broken', 'late', 'other', 'noise', 'heard']));
    expect(troubled({})).not.toEqual(expect.arrayContaining(['reply']));
    // What others say is good or not by its own verdict.
    expect(troubled({ verdict: 'good' })).not.toContain('heard');
    expect(troubled({ verdict: 'bad' })).toEqual(lineKinds);
  });
});

describe('a line is read', () => {
  it('in its own direction, and a reply with what was asked', () => {
    expect(lineReading(line(1, 'request', READ), undefined)).toMatchObject({ direction: 'request', functionCode: 3 });
    expect(lineReading(line(1, 'echo', READ), undefined)).toMatchObject({ direction: 'request' });
    expect(lineReading(line(2, 'reply', THREE), fromHex(READ))).toMatchObject({ direction: 'response', problems: [] });
    const other = fromHex('11060001000 39A9B'.replace(' ', ''));
    expect(lineReading(line(2, 'reply', THREE), other)?.problems).not.toEqual([]);
  });

  it('as what is heard: by the direction it was heard in, and as a request if it is not a reply', () => {
    expect(lineReading(line(1, 'heard', READ, { direction: 'sent' }), undefined)?.direction).toBe('request');
    expect(lineReading(line(1, 'heard', READ), undefined)?.direction).toBe('request');
    expect(lineReading(line(1, 'heard', THREE), undefined)?.direction).toBe('response');
  });

  it('as nothing if it is noise', () => {
    expect(lineReading(line(1, 'noise', READ), undefined)).toBeUndefined();
    expect(lineMeaning(line(1, 'noise', 'FF'), words)).toBe('1 bytes of nothing');
    expect(lineMeaning(line(1, 'request', READ), words)).toBe('request 3 of 8');
  });
});
