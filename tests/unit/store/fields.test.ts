import { effect, type ReadonlySignal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { Fields, Page, steady } from '../../../src/store/index.ts';
import { same } from '../../../src/store/steady.ts';
import { TestWindow } from './window.ts';

function formAt(hash: string) {
  const window = new TestWindow(hash);
  const page = new Page(window.bar, window.after);
  return { window, page, fields: new Fields(page) };
}

/** What a signal says from now on. */
function told(signal: ReadonlySignal<unknown>): unknown[] {
  const values: unknown[] = [];
  effect(() => {
    values.push(signal.value);
  });
  return values;
}

describe('the parts of a field', () => {
  const WRITE = '#rtu/request?unitId=17&functionCode=16&startAddress=1&registers=10+258';

  it('say what the field of each path is', () => {
    const { fields } = formAt(WRITE);
    const { field, text, section, span, value, forced, error, problems } = fields.at('startAddress');
    expect(field.value?.kind).toBe('address');
    expect([text.value, section.value, value.value]).toEqual(['1', 'AP 6.12', 1]);
    expect([span.value?.from, span.value?.to]).toEqual([2, 4]);
    expect([forced.value, error.value, problems.value]).toEqual([undefined, undefined, []]);
    expect(fields.at('unitId').text.value).toBe('17');
    expect(fields.at('unitId').field.value).toBeUndefined();
    expect(fields.at('checksum').section.value).toBe('SL 2.5.1.2');
  });

  it('change only where something else is said', () => {
    const { fields } = formAt(WRITE);
    const [address, registers, layout] = [fields.at('startAddress'), fields.at('registers'), fields.layout];
    const heard = [address.text, address.span, address.problems, registers.span, layout].map(told);
    const texts = told(registers.text);
    fields.type('registers', '10 259');
    fields.type('registers', '10 260');
    expect(heard.map((values) => values.length)).toEqual([1, 1, 1, 1, 1]);
    expect(texts).toEqual(['10 258', '10 259', '10 260']);
    // A third register: its bytes are more.
    fields.type('registers', '10 260 1');
    expect(heard.map((values) => values.length)).toEqual([1, 1, 1, 2, 1]);
  });

  it('say what is wrong with a text, and with its value in the frame', () => {
    const { fields } = formAt(WRITE);
    fields.type('registers', '10 x');
    expect(fields.at('registers').error.value).toMatchObject({ code: 'not-a-number', text: 'x', index: 1 });
    expect(fields.at('startAddress').value.value).toBeUndefined();
    fields.type('registers', '10');
    fields.force('byteCount', '3');
    expect(fields.at('byteCount').forced.value).toBe('3');
    expect(fields.at('byteCount').problems.value.map(({ code }) => code)).toContain('count-contradicts-quantity');
    fields.force('byteCount', undefined);
    expect(fields.at('byteCount').problems.value).toEqual([]);
  });

  it('are those of each field in a group, and a group can be removed', () => {
    const { page, fields } = formAt(
      '#pdu/request?functionCode=20&subRequests=2&subRequests[0].fileNumber=4&subRequests[1].fileNumber=3',
    );
    const { groups } = fields.at('subRequests');
    expect(groups.value.map((group) => group[1])).toEqual(['subRequests[0].fileNumber', 'subRequests[1].fileNumber']);
    const number = told(fields.at('subRequests[0].fileNumber').text);
    fields.removeGroup('subRequests', 0);
    expect(groups.value.length).toBe(1);
    expect(number).toEqual(['4', '3']);
    expect(page.draft.value.texts['subRequests']).toBe('1');
  });

  it('take what is chosen as a step, and what is typed in place', () => {
    const { window, fields } = formAt(WRITE);
    fields.type('startAddress', '2');
    window.wait(300);
    expect(window.entries.length).toBe(1);
    fields.choose('functionCode', '3');
    expect(window.entries.length).toBe(3);
  });
});

describe('a steady signal', () => {
  it('keeps the earlier value while the new one says the same', () => {
    const { page } = formAt('');
    const pair = steady(() => ({ transport: page.draft.value.transport, list: [1, { deep: page.kind.value }] }));
    const heard = told(pair);
    page.edit({ ...page.draft.value, texts: { unitId: '9' } });
    expect(heard.length).toBe(1);
    page.edit({ ...page.draft.value, kind: 'reply' });
    expect(heard.length).toBe(2);
  });

  it.each([
    [1, 1, true],
    [Number.NaN, Number.NaN, true],
    [undefined, null, false],
    [[1, 2], [1, 2], true],
    [[1, 2], [1], false],
    [[], {}, false],
    [{ a: { b: 1 } }, { a: { b: 1 } }, true],
    [{ a: 1 }, { b: 1 }, false],
    [{ a: undefined }, {}, false],
    [() => 1, () => 1, false],
  ])('tells whether %j and %j are the same', (one, other, is) => {
    expect(same(one, other)).toBe(is);
  });
});

describe('what was typed in a field', () => {
  const WRITE = '#rtu/request?unitId=17&functionCode=6&address=1&value=3';

  it('is given back by Escape as it stood when the field got the focus', () => {
    const { page, fields } = formAt(WRITE);
    const before = page.draft.value;
    fields.enter();
    expect(fields.giveBack()).toBe(false);
    fields.type('value', '45 Hz');
    fields.type('value', '45 Hzz');
    expect(fields.giveBack()).toBe(true);
    expect(page.draft.value).toBe(before);
    expect(fields.at('value').text.value).toBe('3');
    expect(fields.giveBack()).toBe(false);
  });

  it('is taken by Enter as a step, and then stands there for Escape', () => {
    const { window, page, fields } = formAt(WRITE);
    fields.enter();
    fields.type('value', '4');
    fields.take();
    fields.type('value', '5');
    expect(fields.giveBack()).toBe(true);
    expect(fields.at('value').text.value).toBe('4');
    page.commit();
    expect(window.entries.at(-1)).toContain('value=4');
  });

  it('of several fields is one step', () => {
    const { fields } = formAt(WRITE);
    fields.chooseAll({ functionCode: '43', meiType: '14' });
    expect(fields.at('meiType').text.value).toBe('14');
    expect(fields.at('functionCode').text.value).toBe('43');
  });
});
