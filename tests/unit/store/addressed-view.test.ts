import { expect, test } from 'vitest';
import { AddressedView, Page } from '../../../src/store/index.ts';
import { TestWindow } from './window.ts';

/** A window with two addresses, and the view that is open at the last. */
function viewAt(hash: string) {
  const window = new TestWindow('#rtu/request?unitId=1&functionCode=7');
  window.goTo(hash);
  const page = new Page(window.bar, window.after);
  const view = new AddressedView(
    page,
    'reference',
    (parts) => ({ search: parts.get('search') ?? '', by: parts.get('by') ?? 'name' }),
    ({ search, by }) => ({ search, by: by === 'name' ? '' : by }),
  );
  const go = (by: number) => {
    window.at += by;
    page.address.take();
  };
  return { window, page, view, go };
}

test('shows what its address says, and what is usual of the rest', () => {
  expect(viewAt('#reference?search=coil').view.shown.value).toEqual({ search: 'coil', by: 'name' });
  expect(viewAt('#reference').view.shown.value).toEqual({ search: '', by: 'name' });
});

test('what is typed comes into the address at a pause, in place, and leaves out what is usual', () => {
  const { window, view } = viewAt('#reference');
  view.change({ search: 'co' });
  window.wait(200);
  view.change({ search: 'coil' });
  expect(view.shown.value).toEqual({ search: 'coil', by: 'name' });
  window.wait(249);
  expect(window.entries.at(-1)).toBe('#reference');
  window.wait(1);
  expect(window.entries).toHaveLength(2);
  expect(window.entries.at(-1)).toBe('#reference?search=coil');
  view.change({ search: '', by: 'code' });
  window.wait(250);
  expect(window.entries.at(-1)).toBe('#reference?by=code');
});

test('a link given by hand shows something else, and Back what was there', () => {
  const { window, page, view, go } = viewAt('#reference');
  view.change({ search: 'coil' });
  page.address.now();
  window.goTo('#reference?search=gateway');
  page.address.take();
  expect(view.shown.value.search).toBe('gateway');
  go(-1);
  expect(view.shown.value.search).toBe('coil');
});

test('the address of another view changes nothing, nor does any address once the view is left', () => {
  const { window, page, view, go } = viewAt('#reference?search=coil');
  window.goTo('#bus?search=gateway');
  page.address.take();
  expect(view.shown.value.search).toBe('coil');
  view.stop();
  go(-1);
  window.goTo('#reference?search=gateway');
  page.address.take();
  expect(view.shown.value.search).toBe('coil');
});
