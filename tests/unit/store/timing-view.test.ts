import { signal } from '@preact/signals-core';
import { expect, test } from 'vitest';
import { KeptChoice, Line, Page, TimingView } from '../../../src/store/index.ts';
import { firstTimingTexts, storedTexts } from '../../../src/workbench/index.ts';
import { TestBrowser, TestWindow } from './window.ts';

/** Unit 17 reads 3 registers: 8 bytes, answered by 11. */
const READ = 'rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3';
/** Unit 17 reads its exception status: 4 bytes, answered by 5. */
const STATUS = 'rtu/request?unitId=17&functionCode=7';

/** A window with a frame, and the Timing view opened from there. */
function timingAt(hash: string, browser = new TestBrowser()) {
  const window = new TestWindow(`#${READ}`);
  const page = new Page(window.bar, window.after);
  const open = (next: string) => {
    window.goTo(next);
    page.address.take();
  };
  open(hash);
  const storage = browser.tab();
  const last = new KeptChoice(storage, 'timing', firstTimingTexts, storedTexts);
  const line = new Line(page, storage, signal(undefined), signal(false));
  return { window, page, open, browser, line, view: new TimingView(page, last, line) };
}

const address = ({ entries }: TestWindow) => new URLSearchParams(entries.at(-1)?.split('?').slice(1).join('?'));

test('times the exchange of the current frame, and completes its address at a pause', () => {
  const { window, view } = timingAt('#timing?baud=9600&format=8N1');
  const { exchange, line } = view.reading.value;
  expect(exchange).toMatchObject({ mode: 'rtu', request: 8, reply: 11, delay: 0 });
  expect(line).toMatchObject({ baud: 9600, bits: 10 });
  window.wait(250);
  expect(window.entries).toHaveLength(2);
  expect(address(window).get('baud')).toBe('9600');
  expect(address(window).get('timeout')).toBe('1 s');
  expect(address(window).get('frame')).toBe(READ);
});

test('a link by hand names its own frame, which is the current one from now on', () => {
  const { page, open, view } = timingAt('#timing');
  open(`#timing?frame=${encodeURIComponent(STATUS)}`);
  expect(page.link.value).toBe(STATUS);
  expect(view.reading.value.exchange).toMatchObject({ request: 4, reply: 5 });
});

test('a frame that comes while the view is open is timed, and named by the address', () => {
  const { window, page, view } = timingAt('#timing');
  window.wait(250);
  page.takeFrame(STATUS);
  expect(view.reading.value.sizes).toMatchObject({ request: 4, reply: 5 });
  window.wait(250);
  expect(address(window).get('frame')).toBe(STATUS);
});

test('the line as typed last is there again, and nothing that belongs to a frame', () => {
  const { window, browser, view } = timingAt('#timing');
  view.set('baud', '115200');
  view.set('mode', 'ascii');
  view.set('request', '100');
  window.wait(250);
  expect(address(window).get('request')).toBe('100');
  const again = timingAt('#timing', browser).view;
  expect(again.shown.value).toEqual({ ...firstTimingTexts, baud: '115200' });
});

test('its line is the one of the page: an address or a field sets it, and it is followed', () => {
  const { window, line, open, view } = timingAt('#timing?baud=9600&format=8n1');
  expect(line.setting.value).toEqual({ baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 });
  expect(view.shown.value).toMatchObject({ baud: '9600', format: '8n1' });
  view.set('baud', '0x4B00');
  expect([line.setting.value.baud, view.shown.value.baud]).toEqual([19_200, '0x4B00']);
  view.set('baud', 'fast');
  expect(line.setting.value.baud).toBe(19_200);
  line.set({ baud: 4800, parity: 'odd' });
  expect(view.shown.value).toMatchObject({ baud: '4800', format: '8O1' });
  window.wait(250);
  expect([address(window).get('baud'), address(window).get('format')]).toEqual(['4800', '8O1']);
  open('#timing?baud=115200');
  expect(line.setting.value).toMatchObject({ baud: 115_200, parity: 'odd' });
  open('#timing?baud=abc&format=9X9');
  expect(line.setting.value).toMatchObject({ baud: 115_200, parity: 'odd' });
  expect(view.shown.value.baud).toBe('abc');
});

test('a text that has to be corrected leaves what does not follow from it', () => {
  const { view } = timingAt('#timing');
  view.set('timeout', 'soon');
  expect(view.reading.value.round).toBeUndefined();
  expect(view.reading.value.exchange).toBeDefined();
  expect(view.reading.value.entries.timeout).toEqual({ error: { code: 'not-a-time', text: 'soon' } });
});

test('the address of the view that is opened next, and of a frame that is shown, stay as they are', () => {
  const { window, page, open, view } = timingAt('#timing');
  view.set('baud', '9600');
  open('#checksum');
  view.set('gap', '2 ms');
  window.wait(250);
  expect(window.entries.at(-1)).toBe('#checksum');
  open('#timing');
  page.show({ ...page.draft.value, texts: { unitId: '1', functionCode: '7' } }, 'step');
  window.wait(250);
  expect(window.entries.at(-1)).toMatch(/^#rtu\/request\?.*unitId=1&functionCode=7/);
  view.stop();
});
