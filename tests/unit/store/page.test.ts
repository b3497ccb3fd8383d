import { effect } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { Addresses, addressOf, Devices, Page, partsAt } from '../../../src/store/index.ts';
import { type Draft, firstDraft } from '../../../src/workbench/index.ts';
import { TestRecords } from './test-records.ts';
import { rememberedIn, TestBrowser, TestWindow } from './window.ts';

/** Read Holding Registers from address 0, one register. */
const READ = '#rtu/request?unitId=1&functionCode=3&startAddress=0&quantity=1';

function pageAt(hash = READ) {
  const window = new TestWindow(hash);
  const page = new Page(window.bar, window.after);
  const addressIs = (text: string): Draft => ({
    ...page.draft.value,
    texts: { ...page.draft.value.texts, startAddress: text },
  });
  const back = (by = -1) => {
    window.at += by;
    page.address.take();
  };
  return { window, page, addressIs, back };
}

const startAddress = (page: Page) => page.evaluation.value.frame?.reading.fields['startAddress'];

describe('the draft and its address', () => {
  it('is the first one where the address says nothing', () => {
    const { page } = pageAt('');
    expect(page.draft.value).toBe(firstDraft);
    expect(page.brokenLink.value).toBeUndefined();
  });

  it('follows typing in place, after a pause', () => {
    const { window, page, addressIs } = pageAt();
    page.edit(addressIs('1'));
    window.wait(200);
    page.edit(addressIs('17'));
    window.wait(249);
    expect(window.entries).toEqual([READ]);
    window.wait(1);
    expect(window.entries).toEqual([`#${page.link.value}`]);
    expect(startAddress(page)).toBe(17);
  });

  it('is a step once the field is left, and Back returns to what stood before', () => {
    const { window, page, addressIs, back } = pageAt();
    page.edit(addressIs('17'));
    window.wait(250);
    page.commit();
    expect(window.entries).toEqual([READ, `#${page.link.value}`]);
    back();
    expect(startAddress(page)).toBe(0);
    back(1);
    expect(startAddress(page)).toBe(17);
  });

  it('is no step where nothing was typed', () => {
    const { window, page } = pageAt();
    page.step(page.draft.value);
    const { length } = window.entries;
    page.commit();
    page.commit();
    expect(window.entries).toHaveLength(length);
  });

  it('has the address of a field that is left as it was, though others were typed meanwhile', () => {
    const { window, page, addressIs } = pageAt();
    page.edit(addressIs('17'));
    window.wait(250);
    page.edit(addressIs('0'));
    page.commit();
    window.wait(250);
    expect(window.entries).toEqual([READ]);
  });

  it('has the open tab of the page that nobody has touched, so that Back finds it', () => {
    const { window, page, back } = pageAt('');
    page.openTab('values');
    window.wait(250);
    page.step({ ...firstDraft, texts: { ...firstDraft.texts, address: '17' } });
    page.openTab('wire');
    window.wait(250);
    back();
    expect(page.tab.value).toBe('values');
    expect(page.draft.value.texts).toEqual(firstDraft.texts);
    back(1);
    expect(page.tab.value).toBe('wire');
  });

  it('gives up what was to follow when Back is pressed', () => {
    const { window, page, addressIs, back } = pageAt();
    page.step(addressIs('5'));
    page.edit(addressIs('17'));
    back();
    window.wait(1000);
    expect(window.entries[0]).toBe(READ);
    expect(startAddress(page)).toBe(0);
  });

  it('says what of an address could not be read until something is typed', () => {
    const { page, addressIs } = pageAt('#fc=nonsense&other');
    expect(page.brokenLink.value?.hash).toBe('#fc=nonsense&other');
    page.edit(addressIs('1'));
    expect(page.brokenLink.value).toBeUndefined();
  });

  it('is worked out once for each draft, and told once', () => {
    const { page, addressIs } = pageAt();
    const told: unknown[] = [];
    effect(() => {
      told.push(page.evaluation.value);
    });
    page.step(addressIs('17'));
    expect(told).toHaveLength(2);
    expect(page.evaluation.value).toBe(told[1]);
  });
});

describe('the views', () => {
  it('are what the address names', () => {
    expect(pageAt('#timing?baud=9600').page.view.value).toBe('timing');
    expect(pageAt('#fc=3').page.view.value).toBeUndefined();
  });

  it('leave the draft alone', () => {
    const { window, page, addressIs, back } = pageAt();
    page.step(addressIs('17'));
    window.goTo('#timing');
    page.address.take();
    expect(page.view.value).toBe('timing');
    expect(window.entries).toHaveLength(3);
    expect(startAddress(page)).toBe(17);
    // Their own fields are left without a step of the draft.
    page.commit();
    expect(window.entries).toHaveLength(3);
    back();
    expect(page.view.value).toBeUndefined();
    expect(startAddress(page)).toBe(17);
  });

  it('follow typing in their address, in place', () => {
    const { window, page } = pageAt('#reference');
    page.follow('reference', () => ({ search: 'coil & more', empty: '' }));
    window.wait(250);
    expect(window.entries).toEqual(['#reference?search=coil+%26+more']);
  });

  it('are found by Back as they were typed when a frame is shown from them', () => {
    const { window, page, addressIs, back } = pageAt('#reference');
    page.follow('reference', () => ({ search: 'coil' }));
    page.show(addressIs('17'), 'edit');
    expect(page.view.value).toBeUndefined();
    expect(window.entries).toEqual(['#reference?search=coil', `#${page.link.value}`]);
    back();
    expect(page.view.value).toBe('reference');
    expect(partsAt(page.address.given.value.hash).get('search')).toBe('coil');
  });

  it('leave out parts that are too long for an address', () => {
    expect(addressOf('reference', { search: 'x'.repeat(8000) })).toHaveLength('#reference?search='.length + 8000);
    expect(addressOf('checksum', { search: 'x'.repeat(8001), sort: 'check' })).toBe('#checksum?sort=check');
  });

  it('read back any parts that they wrote', () => {
    const parts = { search: 'a=b&c?#+ %', sort: '-check' };
    expect(Object.fromEntries(partsAt(addressOf('checksum', parts)))).toEqual(parts);
    expect(partsAt('#checksum?a=1&a=2').get('a')).toBe('1');
  });
});

describe('an address as the manual prints it', () => {
  it('is a frame’s address by the convention chosen', () => {
    const { page } = pageAt();
    const storage = new TestBrowser().tab();
    const devices = new Devices(page, storage, rememberedIn(storage), new TestRecords().tab());
    const addresses = new Addresses(page, storage, { device: devices.chosen, registerNames: devices.registerNames });
    addresses.convention.value = 'digits';
    const next = addresses.withTyped(page.draft.value, 'startAddress', '40108', 'holding-register');
    page.edit(next);
    expect(startAddress(page)).toBe(107);
    expect(addresses.shown(next, 'startAddress', next.texts['startAddress']!, 'holding-register').text).toBe('40108');
    addresses.convention.value = 'protocol';
    expect(startAddress(page)).toBe(107);
  });
});
