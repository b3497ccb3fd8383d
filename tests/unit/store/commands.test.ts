import { describe, expect, it } from 'vitest';
import { Commands, type KeyPress, Page } from '../../../src/store/index.ts';
import { languages } from '../../../src/words/index.ts';
import { TestBrowser, TestWindow } from './window.ts';

const FRAME = '#rtu/request?unitId=1&functionCode=3&startAddress=0&quantity=1';

function commandsAt(hash = FRAME, browser = new TestBrowser()) {
  const window = new TestWindow(hash);
  const page = new Page(window.bar, window.after);
  const commands = new Commands(page, browser.tab());
  const press = (key: string, more: Partial<KeyPress> = {}) =>
    commands.press({ key, ctrl: false, alt: false, shift: false, typing: false, taken: false, ...more });
  return { window, page, commands, press };
}

describe('a key', () => {
  it('does nothing where nobody offers its command', () => {
    const { press } = commandsAt();
    expect(press('F8')).toBe(false);
    expect(press('x')).toBe(false);
    expect(press('Escape')).toBe(false);
  });

  it('does what was offered last, until that ends', () => {
    const { commands, press } = commandsAt();
    const did: string[] = [];
    const end = commands.offer('close', () => did.push('outer'));
    const endInner = commands.offer('close', () => did.push('inner'));
    expect(press('Escape')).toBe(true);
    endInner();
    press('Escape');
    end();
    expect(press('Escape')).toBe(false);
    expect(did).toEqual(['inner', 'outer']);
  });

  it('goes to the input from any view: the Frame view is opened, and the input takes it when it is there', () => {
    const { page, commands, press } = commandsAt('#timing');
    let went = 0;
    expect(press('k', { ctrl: true, typing: true })).toBe(true);
    expect(page.view.value).toBeUndefined();
    commands.offer('focus-input', () => went++)();
    expect(went).toBe(1);
    commands.offer('focus-input', () => went++);
    expect(went).toBe(1);
    press('k', { ctrl: true });
    expect(went).toBe(2);
  });

  it('stops what runs before it closes anything, also behind a dialog', () => {
    const { commands, press } = commandsAt();
    const did: string[] = [];
    commands.offer('close', () => did.push('close'));
    const end = commands.offer('stop', () => did.push('stop'));
    press('Escape', { taken: true });
    press('Escape');
    end();
    expect(press('Escape', { taken: true })).toBe(false);
    press('Escape');
    expect(did).toEqual(['stop', 'stop', 'close']);
  });

  it('is told by what is held with it', () => {
    const { commands, press } = commandsAt();
    const did: string[] = [];
    commands.offer('next-fault', () => did.push('next'));
    commands.offer('previous-fault', () => did.push('previous'));
    commands.offer('focus-input', () => did.push('focus'));
    press('F8');
    press('F8', { shift: true });
    // Caps Lock writes the other letter.
    press('k', { ctrl: true });
    press('K', { ctrl: true });
    for (const more of [{ ctrl: true }, { alt: true }]) expect(press('F8', more)).toBe(false);
    expect(press('k')).toBe(false);
    expect(did).toEqual(['next', 'previous', 'focus', 'focus']);
  });

  it('that is a character is typed where text is typed; with Ctrl it is a command there too', () => {
    const { commands, press } = commandsAt();
    const did: string[] = [];
    commands.offer('copy-frame', () => did.push('copy'));
    commands.offer('focus-input', () => did.push('focus'));
    expect(press('c', { typing: true })).toBe(false);
    expect(press('c')).toBe(true);
    expect(press('k', { typing: true, ctrl: true })).toBe(true);
    expect(did).toEqual(['copy', 'focus']);
  });

  it('that is a character alone can be turned off, and stays so', () => {
    const browser = new TestBrowser();
    const { commands, press } = commandsAt(FRAME, browser);
    commands.singleKeys.value = false;
    expect(press('2')).toBe(false);
    expect(commands.keyOf('view-checksum')).toBeUndefined();
    expect(commands.keyOf('keys')).toBe('Ctrl+/');
    expect(commandsAt(FRAME, browser).press('2')).toBe(false);
  });
});

describe('views', () => {
  it('are opened as by a link, so that Back returns', () => {
    const { window, page, press } = commandsAt();
    expect(press('1')).toBe(false);
    expect(press('2')).toBe(true);
    expect(page.view.value).toBe('log');
    expect(window.entries).toEqual([FRAME, '#log']);
    expect(press('1')).toBe(true);
    expect(page.view.value).toBeUndefined();
    expect(window.entries).toEqual([FRAME, '#log', FRAME]);
  });

  it('keep what is being typed', () => {
    const { window, page, press } = commandsAt();
    page.edit({ ...page.draft.value, texts: { ...page.draft.value.texts, quantity: '7' } });
    press('5');
    press('1');
    expect(page.evaluation.value.frame?.reading.fields['quantity']).toBe(7);
    expect(window.entries).toHaveLength(3);
  });
});

describe('the table', () => {
  it('has a title for each command, and no two that are done by one key at once', async () => {
    const { commands } = commandsAt();
    const { titles } = await languages.en.commands();
    expect(new Set(commands.table.map(({ id }) => id))).toEqual(new Set(Object.keys(titles)));
    const keys = commands.table.map(({ key }) => key);
    expect(keys.filter((key, index) => keys.indexOf(key) !== index)).toEqual(['Escape']);
  });

  it('is shown by ? and by Ctrl and /', () => {
    const { commands, press } = commandsAt();
    press('?', { shift: true });
    expect(commands.listed.value).toBe(true);
    commands.listed.value = false;
    press('/', { ctrl: true, typing: true });
    expect(commands.listed.value).toBe(true);
  });
});
