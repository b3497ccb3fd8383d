import { describe, expect, it } from 'vitest';
import { LogAddress, Page } from '../../../src/store/index.ts';
import { playedTrace } from './played-trace.ts';
import { TestWindow } from './window.ts';

// AP 6.3: a request without a reply, and one that is refused.
const LOG =
  '10:31:12.300 Tx 11 03 00 6B 00 03 76 87\n10:31:14.300 Tx 11 03 00 00 00 04 46 99\n10:31:14.310 Rx 11 83 02 C1 34';

/** A window whose last entry is an address of the Log view. */
function logAt(hash: string) {
  const window = new TestWindow('#rtu/request?unitId=1&functionCode=7');
  window.goTo(hash);
  const page = new Page(window.bar, window.after);
  const { view: log, work, ...rest } = playedTrace();
  const address = new LogAddress(page, log);
  const settle = () => {
    for (let turn = 0; turn < 4; turn++) work();
    window.wait(250);
  };
  settle();
  const go = (by: number) => {
    window.at += by;
    page.address.take();
    settle();
  };
  const to = (next: string) => {
    window.goTo(next);
    page.address.take();
    settle();
  };
  return { window, page, log, address, settle, go, to, ...rest };
}

describe('the address of the Log view', () => {
  it('opens the demo log with its filter, the frame that is chosen, and the tab', () => {
    const { log, address, shown, window } = logAt('#log?log=demo&filter=unit%3A6&row=36&tab=values');
    expect(log.summary.value?.frames).toBe(200);
    expect([log.filter.value, log.record.value, log.rowsKept.value]).toEqual(['unit:6', 35, 70]);
    expect(shown.at(-1)?.frame.index).toBe(35);
    expect(address.tab.value).toBe('values');
    expect([address.untaken.value, address.waiting.value]).toEqual([[], undefined]);
    expect(window.entries.at(-1)).toBe('#log?log=demo&filter=unit%3A6&row=36&tab=values');
  });

  it('follows what is typed in place, and makes what is clicked a step', () => {
    const { log, window, settle, go } = logAt('#log?log=demo');
    log.setFilter('uni', 'edit');
    log.setFilter('unit:6', 'edit');
    settle();
    expect(window.entries.slice(1)).toEqual(['#log?log=demo&filter=unit%3A6']);
    log.setFilter('crc');
    settle();
    expect(window.entries.slice(1)).toEqual(['#log?log=demo&filter=unit%3A6', '#log?log=demo&filter=crc']);
    log.choose(0);
    settle();
    expect(window.entries.at(-1)).toBe('#log?log=demo&filter=crc&row=93');
    go(-1);
    expect([log.filter.value, log.record.value]).toEqual(['unit:6', undefined]);
    go(1);
    expect([log.filter.value, log.record.value, log.rowsKept.value]).toEqual(['crc', 92, 1]);
    go(-2);
    expect(window.entries[0]).toBe('#rtu/request?unitId=1&functionCode=7');
  });

  it('finds the log as it was left, where the way to the view names nothing', () => {
    const { log, window, go, to, settle } = logAt('#log?log=demo');
    log.setFilter('crc', 'edit');
    settle();
    go(-1);
    to('#log');
    expect([log.filter.value, window.entries.at(-1)]).toEqual(['crc', '#log?log=demo&filter=crc']);
  });

  it('keeps what it says of a log that was pasted for the one that is opened next', () => {
    const { log, address, window, settle } = logAt('#log?log=pasted&filter=exception&row=3');
    expect(log.state.value.kind).toBe('empty');
    expect(address.waiting.value).toMatchObject({ source: 'pasted', filter: 'exception', record: 2 });
    address.open(LOG);
    settle();
    expect([log.rowsKept.value, log.filter.value, log.record.value]).toEqual([1, 'exception', 2]);
    expect(address.waiting.value).toBeUndefined();
    expect(window.entries.slice(1)).toEqual(['#log?log=pasted&filter=exception&row=3']);
  });

  it('leads from a pasted log back to the demo, and forward to where the pasted one is gone', () => {
    const { log, address, settle, go } = logAt('#log?log=demo&filter=crc');
    address.open(LOG);
    settle();
    log.setFilter('no-reply', 'edit');
    settle();
    expect(log.summary.value?.frames).toBe(3);
    go(-1);
    expect([log.summary.value?.frames, log.filter.value]).toEqual([200, 'crc']);
    go(1);
    expect(log.state.value.kind).toBe('empty');
    expect(address.waiting.value).toMatchObject({ source: 'pasted', filter: 'no-reply' });
  });

  it('says what it did not take, and which frame the list lacks', () => {
    const { log, address, to } = logAt('#log?log=demo&row=x&fliter=crc');
    expect(address.untaken.value.map(({ name }) => name)).toEqual(['row', 'fliter']);
    to('#log?log=demo&row=201');
    expect([address.untaken.value, log.missing.value]).toEqual([[], 200]);
    to('#log?log=demo&filter=crc&row=1');
    expect(log.missing.value).toBe(0);
    to('#log?log=demo&filter=unti%3A3');
    expect(log.read.value.kind).toBe('mistakes');
    expect(log.missing.value).toBeUndefined();
  });

  it('leaves the address of another view as it is', () => {
    const { log, window, to, settle } = logAt('#log?log=demo');
    to('#timing');
    log.setFilter('crc');
    settle();
    expect(window.entries.at(-1)).toBe('#timing');
  });
});
