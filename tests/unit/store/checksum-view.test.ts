import { describe, expect, it } from 'vitest';
import { checksum, checksums } from '../../../src/modbus/index.ts';
import { ChecksumView, type DigestWorkers, Page } from '../../../src/store/index.ts';
import { CRC_MODBUS, checksumValues, type DigestAnswer, digestInput } from '../../../src/workbench/index.ts';
import { TestWindow } from './window.ts';

/** Unit 2 reads its exception status: 02 07, and its CRC 41 12. */
const STATUS = '#rtu/request?unitId=2&functionCode=7';

/** Workers that answer when the test wants them to. */
class TestWorkers implements DigestWorkers {
  readonly most = 2;
  time = 0;
  readonly running: {
    readonly task: Parameters<DigestWorkers['start']>[0];
    readonly take: (answer: DigestAnswer) => void;
    readonly ended: () => void;
    alive: boolean;
  }[] = [];

  now(): number {
    return this.time;
  }

  start(...[task, take, ended]: Parameters<DigestWorkers['start']>) {
    const worker = { task, take, ended, alive: true };
    this.running.push(worker);
    return () => {
      worker.alive = false;
    };
  }

  get alive() {
    return this.running.filter(({ alive }) => alive);
  }
}

function viewAt(hash: string) {
  const window = new TestWindow(STATUS);
  const page = new Page(window.bar, window.after);
  const open = (next: string) => {
    window.goTo(next);
    page.address.take();
  };
  open(hash);
  const workers = new TestWorkers();
  const view = new ChecksumView(page, workers, 'Own parameters');
  const valueIn = (name: string) => view.rows.value.find((row) => row.name === name)?.value;
  return { window, page, open, workers, view, valueIn };
}

/** A file of so many bytes, of which nothing is read. */
const fileOf = (size: number) => ({
  name: 'dump.bin',
  size,
  slice: (from: number, to: number) => ({ size: Math.min(to, size) - from }),
});

const MB = 2 ** 20;

describe('what is typed', () => {
  it('is the current frame at first, without its checksum', () => {
    const { view, valueIn } = viewAt('#checksum');
    expect(view.shown.value.text).toBe('02 07');
    expect(view.results.value.map(({ name }) => name)).toEqual(['CRC-16/MODBUS', 'LRC']);
    // Printed in the specification, low byte first: 41 12.
    expect(valueIn('CRC-16/MODBUS')).toBe(0x1241);
    view.takeBytes(view.frame.value!.whole);
    expect(view.shown.value.text).toBe('02 07 41 12');
    expect(valueIn('CRC-16/MODBUS')).toBe(0);
  });

  it('comes into the address with the algorithm, and out of it', () => {
    const { window, view } = viewAt('#checksum?bytes=31+32&algorithm=CRC-16%2FKERMIT&as=text&search=crc&sort=-value');
    expect(view.shown.value).toMatchObject({ text: '31 32', kind: 'text', sort: { by: 'value', down: true } });
    expect(view.chosen.value.name).toBe('CRC-16/KERMIT');
    expect(view.results.value).toHaveLength(3);
    view.choose('LRC');
    view.change({ kind: 'bytes', sort: undefined, search: '' });
    window.wait(250);
    expect(window.entries.at(-1)).toBe('#checksum?bytes=31+32&algorithm=LRC');
  });

  it('is searched and sorted as the table shows it', () => {
    const { view } = viewAt('#checksum?bytes=02+07&search=0x1241');
    expect(view.found.value.map(({ name }) => name)).toContain('CRC-16/MODBUS');
    view.change({ search: '', sort: { by: 'value', down: true } });
    const values = view.found.value.map(({ value }) => value ?? -1);
    expect(values).toEqual(values.toSorted((a, b) => b - a));
    expect(values).toHaveLength(checksums.length);
  });

  it('keeps what it has worked out while something else changes', () => {
    const { view } = viewAt('#checksum');
    const rows = view.rows.value;
    view.change({ claim: '0x1241' });
    expect(view.rows.value).toBe(rows);
    view.change({ text: '02 08' });
    expect(view.rows.value).not.toBe(rows);
  });

  it('is worked out in a worker if it is long, of which nothing more is heard once something else is typed', () => {
    const { view, workers } = viewAt('#checksum');
    const long = 'A5 '.repeat(10_000);
    view.change({ text: long });
    expect(view.computing.value).toBe(true);
    expect(view.rows.value[0]?.value).toBeUndefined();
    const [worker] = workers.alive;
    expect(worker?.task).toMatchObject({ kind: 'text', text: long });
    worker?.take({ kind: 'whole', ...digestInput(long, 'bytes') });
    expect(view.bytes.value).toHaveLength(10_000);
    expect(workers.alive).toHaveLength(0);
    view.change({ text: `${long}00` });
    view.takeText('02 07');
    expect(workers.alive).toHaveLength(0);
    expect(view.bytes.value).toEqual(Uint8Array.of(2, 7));
  });
});

describe('own parameters', () => {
  const OWN = '#checksum?bytes=02+07&algorithm=own&width=16&poly=0x8005&init=0xFFFF&refin=1&refout=1';

  it('are the first row, and are chosen by a name of their own', () => {
    const { view, valueIn } = viewAt(OWN);
    expect(view.chosen.value).toBe(view.own.value);
    expect(view.rows.value[0]?.name).toBe('Own parameters');
    expect(valueIn('Own parameters')).toBe(0x1241);
    view.choose('LRC');
    view.choose(view.own.value!.name);
    expect(view.shown.value.algorithm).toBe('own');
  });

  it('that make no CRC leave CRC-16/MODBUS in its place, and so does a name that no algorithm has', () => {
    for (const hash of ['#checksum?algorithm=own&width=16', '#checksum?algorithm=CRC-17']) {
      const { view } = viewAt(hash);
      expect(view.wanted.value).toBeUndefined();
      expect(view.chosen.value).toBe(CRC_MODBUS);
    }
  });
});

describe('a file', () => {
  it('that is small has all checksums', () => {
    const { view, workers, valueIn } = viewAt('#checksum');
    view.change({ file: fileOf(MB) });
    expect(workers.alive.map(({ task }) => task.kind)).toEqual(['file']);
    const bytes = Uint8Array.of(2, 7);
    workers.alive[0]?.take({ kind: 'whole', reading: { bytes, problems: [] }, values: checksumValues(bytes) });
    expect(valueIn('CRC-16/MODBUS')).toBe(0x1241);
  });

  it('that is large is read in one pass for what is shown, and once more for an algorithm that is chosen later', () => {
    const { view, workers, valueIn } = viewAt('#checksum');
    view.change({ file: fileOf(MB + 1) });
    const [first] = workers.alive;
    expect(first?.task).toMatchObject({ kind: 'part', first: true, algorithms: ['LRC', 'CRC-16/MODBUS'] });
    // Chosen while it is still read, so that it waits.
    view.choose('CRC-16/KERMIT');
    expect(workers.alive).toEqual([first]);
    workers.time = 500;
    first?.take({ kind: 'progress', bytes: 1000 });
    expect(view.digest.value).toMatchObject({ kind: 'computing', done: 1000, speed: 2000 });
    first?.take({ kind: 'part', states: [0, 0x4b37] });
    expect(valueIn('CRC-16/MODBUS')).toBe(0x4b37);
    expect(view.computing.value).toBe(true);
    expect(workers.alive.map(({ task }) => task)).toMatchObject([{ kind: 'part', algorithms: ['CRC-16/KERMIT'] }]);
    workers.alive[0]?.take({ kind: 'part', states: [0x2189] });
    expect(view.digest.value.kind).toBe('done');
    expect(valueIn('CRC-16/KERMIT')).toBe(0x2189);
    expect(valueIn('CRC-16/MODBUS')).toBe(0x4b37);
    view.choose('CRC-16/MODBUS');
    expect(workers.alive).toHaveLength(0);
  });

  it('of 32 MB or more is cut into a part for each worker, whose values are joined in the order of the file', () => {
    const { view, workers, valueIn } = viewAt('#checksum');
    const size = 2 ** 25;
    view.change({ file: fileOf(size) });
    const tasks = workers.alive.map(({ task }) => task);
    expect(tasks).toMatchObject([
      { first: true, file: { size: size / 2 } },
      { first: false, file: { size: size / 2 } },
    ]);
    const zeros = new Uint8Array(size / 2);
    const [head, tail] = workers.alive;
    const states = (begun: number) => [0, CRC_MODBUS.add(begun, zeros)];
    tail?.take({ kind: 'part', states: states(0) });
    expect(view.computing.value).toBe(true);
    head?.take({ kind: 'part', states: states(CRC_MODBUS.start) });
    expect(valueIn('CRC-16/MODBUS')).toBe(checksum(CRC_MODBUS, new Uint8Array(size)));
  });

  it('that is given up is not known, and can be read again', () => {
    const { view, workers } = viewAt('#checksum');
    view.change({ file: fileOf(MB + 1) });
    view.cancel();
    expect(view.digest.value.kind).toBe('cancelled');
    expect(workers.alive).toHaveLength(0);
    view.again();
    expect(view.computing.value).toBe(true);
    expect(workers.alive).toHaveLength(1);
  });

  it('fails if a worker says so, or ends', () => {
    for (const end of ['says', 'ends'] as const) {
      const { view, workers, valueIn } = viewAt('#checksum');
      view.change({ file: fileOf(2 ** 25) });
      const [worker] = workers.alive;
      if (end === 'says') worker?.take({ kind: 'failed' });
      else worker?.ended();
      expect(view.digest.value.kind).toBe('failed');
      expect(valueIn('CRC-16/MODBUS')).toBeUndefined();
      expect(workers.alive).toHaveLength(0);
    }
  });

  it('gives way to an address, and ends with the view', () => {
    const { view, workers, open } = viewAt('#checksum');
    view.change({ file: fileOf(MB + 1) });
    open('#checksum?bytes=02+07');
    expect(workers.alive).toHaveLength(0);
    expect(view.bytes.value).toEqual(Uint8Array.of(2, 7));
    view.change({ file: fileOf(MB + 1) });
    view.stop();
    expect(workers.alive).toHaveLength(0);
  });
});
