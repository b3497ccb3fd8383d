import { describe, expect, it } from 'vitest';
import { Page, WaitingFrame } from '../../../src/store/index.ts';
import { firstDraft } from '../../../src/workbench/index.ts';
import { TestWindow } from './window.ts';

/** AP 6.6: register 2 of unit 17 is 3. */
const FRAME = 'rtu/request?unitId=17&functionCode=6&address=1&value=3';

/** The storage of a tab. */
function tab() {
  const texts = new Map<string, string>();
  return {
    texts,
    storage: () => ({
      getItem: (key: string) => texts.get(key) ?? null,
      setItem: (key: string, text: string) => void texts.set(key, text),
      removeItem: (key: string) => void texts.delete(key),
    }),
  };
}

/** A page that is loaded at an address, in this tab. */
function loaded(hash: string, { storage }: Pick<ReturnType<typeof tab>, 'storage'>, again = true) {
  const window = new TestWindow(hash);
  const page = new Page(window.bar, window.after);
  const waiting = new WaitingFrame(page, storage);
  waiting.take(again);
  return { page, waiting };
}

describe('a frame that waits while another view is open', () => {
  it('is there again when the page is loaded again', () => {
    const one = tab();
    const before = loaded('', one);
    before.page.takeFrame(FRAME);
    before.waiting.keep();
    for (const hash of ['#reference', '#log?log=demo', '#devices']) {
      const { page, waiting } = loaded(hash, one);
      expect(page.frameLink.value).toBe(before.page.frameLink.value);
      expect(page.view.value).toBe(hash.slice(1).split('?')[0]);
      waiting.keep();
    }
  });

  it('is not that of a page that was left otherwise, nor one that was kept before', () => {
    const one = tab();
    const before = loaded('', one);
    before.page.takeFrame(FRAME);
    before.waiting.keep();
    expect(loaded('#reference', one, false).page.draft.value).toBe(firstDraft);
    expect(loaded('#reference', one).page.draft.value).toBe(firstDraft);
    expect(one.texts.size).toBe(0);
  });

  it('leaves a frame alone that is here, and keeps none that nobody has touched', () => {
    const one = tab();
    const before = loaded('', one);
    before.waiting.keep();
    expect(one.texts.size).toBe(0);
    before.page.takeFrame(FRAME);
    before.waiting.keep();
    const other = 'rtu/request?unitId=9&functionCode=7';
    const { page } = loaded(`#${other}`, one);
    expect(page.frameLink.value).toBe(other);
  });

  it('is in the history only where the browser keeps nothing', () => {
    const refuses = (): never => {
      throw new Error('refused');
    };
    const { page, waiting } = loaded('', { storage: refuses });
    page.takeFrame(FRAME);
    waiting.keep();
    expect(loaded('#reference', { storage: refuses }).page.draft.value).toBe(firstDraft);
  });
});
