import { describe, expect, it } from 'vitest';
import { defaultRules, defaultSettings } from '../../../../src/bus/index.ts';
import { firstPort, readPortSettings, readRules } from '../../../../src/workbench/bus/link-settings.ts';
import { defaultPoll, linesFor, readPollSettings } from '../../../../src/workbench/bus/poll-settings.ts';
import { defaultScan, formatsFor, readScanSettings, scanOrder } from '../../../../src/workbench/bus/scan-settings.ts';

/** What storage may hold in place of an object. */
const NONSENSE = [null, undefined, 7, 'text', [], [1], true, { constructor: 1 }];

describe('how a port is opened, out of storage', () => {
  it('is taken field by field, each if it is in its range', () => {
    const own = { flowControl: 'hardware', bufferSize: 1 };
    expect(readPortSettings({ ...own, baud: 9600 })).toEqual(own);
    expect(readPortSettings({ bufferSize: 0, flowControl: 'xon' })).toEqual(firstPort);
    expect(readPortSettings({ ...own, bufferSize: 16_777_217 })).toEqual({ ...own, bufferSize: 4096 });
    for (const stored of NONSENSE) expect(readPortSettings(stored)).toEqual(firstPort);
  });
});

describe('how transactions are carried out, out of storage', () => {
  it('is taken field by field, each if it is in its range', () => {
    const own = {
      transport: 'ascii',
      timeout: 60_000,
      retries: 10,
      turnaround: 0,
      echo: 'on',
      quiet: false,
      punctual: false,
      patience: 200,
    };
    expect(readRules(own)).toEqual(own);
    const wrong = {
      transport: 'tcp',
      timeout: 0,
      retries: 11,
      turnaround: -1,
      echo: 'x',
      quiet: 0,
      patience: '200',
      gap: 9,
    };
    expect(readRules(wrong)).toEqual(defaultRules);
    for (const stored of NONSENSE) expect(readRules(stored)).toEqual(defaultRules);
  });
});

describe('how is polled, out of storage', () => {
  it('is taken field by field, each if it is in its range', () => {
    const lines = { drive: ['Speed', 'Speed#1'], __proto__x: [] };
    const own = { from: 'device', interval: 0, unit: 255, registers: 1, bits: 2000, gap: 0, window: 0, lines };
    expect(readPollSettings(own)).toEqual(own);
    const wrong = { from: 'x', interval: -1, unit: 0, registers: 126, bits: 2001, gap: -1, window: 61, lines: 3 };
    expect(readPollSettings(wrong)).toEqual(defaultPoll);
    expect(readPollSettings({ lines: { drive: ['Speed'], pump: [1], fan: 'x' } }).lines).toEqual({ drive: ['Speed'] });
    for (const stored of NONSENSE) expect(readPollSettings(stored)).toEqual(defaultPoll);
  });

  it('has no lines for a profile with a name that every object has', () => {
    for (const id of ['constructor', '__proto__', 'toString']) expect(linesFor(defaultPoll, id)).toEqual([]);
    const stored = JSON.parse('{"lines":{"__proto__":["Speed"]}}') as unknown;
    expect(linesFor(readPollSettings(stored), '__proto__')).toEqual(['Speed']);
  });
});

describe('how is scanned, out of storage', () => {
  it('is taken field by field, each if it is in its range', () => {
    const own = {
      ...defaultScan,
      what: 'addresses',
      transport: 'ascii',
      firstUnit: 247,
      speeds: [9600, 19_200],
      formats: ['7E1'],
      table: 'coil',
      last: 65_535,
    };
    expect(readScanSettings(own)).toEqual(own);
    const wrong = {
      what: 1,
      transport: 'pdu',
      timeout: 0,
      firstUnit: 0,
      lastUnit: 248,
      table: 'file-record',
      bits: 1.5,
    };
    expect(readScanSettings(wrong)).toEqual(defaultScan);
    expect(readScanSettings({ speeds: [7, 9600], formats: 'x' })).toMatchObject({ speeds: [9600], formats: [] });
    for (const stored of NONSENSE) expect(readScanSettings(stored)).toEqual(defaultScan);
  });
});

describe('an order to scan', () => {
  it('tries each speed with each format that has room for the mode', () => {
    const settings = { ...defaultScan, speeds: [9600, 19_200], formats: ['8N2', '7E1'] };
    const order = scanOrder(settings, defaultSettings);
    // Seven bits have no room for the bytes of RTU (SL 2.5.1).
    expect(order?.what === 'units' && order.lines).toEqual([
      { ...defaultSettings, baud: 9600, parity: 'none', stopBits: 2 },
      { ...defaultSettings, baud: 19_200, parity: 'none', stopBits: 2 },
    ]);
    expect(formatsFor('ascii')).toContain('7E1');
    expect(formatsFor('rtu')).not.toContain('7E1');
  });

  it('leaves the line as it is when neither is chosen, and keeps what is not chosen', () => {
    const linesOf = (change: Partial<typeof defaultScan>) => {
      const order = scanOrder({ ...defaultScan, ...change }, defaultSettings);
      return order?.what === 'units' && order.lines;
    };
    expect(linesOf({})).toEqual([]);
    expect(linesOf({ speeds: [1200] })).toEqual([{ ...defaultSettings, baud: 1200 }]);
    expect(linesOf({ formats: ['8N1'] })).toEqual([{ ...defaultSettings, parity: 'none' }]);
  });

  it('is not there when the last comes before the first', () => {
    expect(scanOrder({ ...defaultScan, firstUnit: 5, lastUnit: 4 }, defaultSettings)).toBeUndefined();
    expect(scanOrder({ ...defaultScan, what: 'addresses', first: 5, last: 4 }, defaultSettings)).toBeUndefined();
    expect(scanOrder({ ...defaultScan, what: 'functions', first: 5, last: 4 }, defaultSettings)).toMatchObject({
      what: 'functions',
      unit: 1,
    });
  });

  it('asks for registers or for bits, as many as the table allows', () => {
    const settings = { ...defaultScan, what: 'addresses' as const, registers: 10, bits: 100 };
    expect(scanOrder({ ...settings, table: 'coil' }, defaultSettings)).toMatchObject({ table: 'coil', most: 100 });
    expect(scanOrder({ ...settings, table: 'input-register' }, defaultSettings)).toMatchObject({ most: 10 });
  });
});
