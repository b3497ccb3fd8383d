import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { diagnose, findingKinds } from '../../src/diagnosis/index.ts';
import { fromHex } from '../../src/modbus/index.ts';
import { languages } from '../../src/words/index.ts';
import { FrameForm } from '../browser/form.ts';
import { allCame, expect, test } from './page.ts';

const words = await languages.en.read();
const input = await languages.en.input();
const { readAsFrame } = await languages.en.paste();
const findingWords = await languages.en.findings();

interface UserFrame {
  readonly id: string;
  readonly transport: 'rtu' | 'ascii' | 'tcp' | 'data';
  readonly pasted: string;
  readonly pastedIsProse?: boolean;
  readonly hex: string;
  readonly answering?: string;
  readonly finding: string;
}

const userFrames = JSON.parse(
  readFileSync(new URL('../vectors/user-frames.json', import.meta.url), 'utf8'),
) as readonly UserFrame[];

const strip = (page: Page) => page.getByRole('list', { name: 'The frame' });
const text = (page: Page) => page.getByRole('textbox', { name: input.label });
const bytes = (page: Page, pairs: string, what?: string) => new FrameForm(page).expectBytes(pairs, what);
const frame = (page: Page) => page.getByRole('region', { name: 'The frame' });
const why = (page: Page) => frame(page).getByRole('button', { name: /^Why/ });

/** Pastes as a person does, with nothing that could be typed in having the focus. */
async function paste(page: Page, what: string): Promise<void> {
  await page.evaluate((content) => navigator.clipboard.writeText(content), what);
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  await page.keyboard.press('Control+V');
}

async function open(page: Page, hash = ''): Promise<void> {
  await page.goto(`./${hash}`);
  await expect(strip(page)).toBeVisible();
  await allCame(page);
}

const log = [
  '[RTU]>Tx > 10:31:12:300 - 01  03  00  6B  00  02  B5  D7',
  '[RTU]>Rx > 10:31:12:316 - 01  03  04  02  2B  00  00  8B  83',
  '[RTU]>Tx > 10:31:13:300 - 01  03  00  00  00  04  44  09',
  '[RTU]>Rx > 10:31:13:316 - 01  83  02  C0  F1',
].join('\n');

test('the input of a fresh page has the focus, and what is typed in it is one step', async ({ page }) => {
  await open(page);
  await expect(text(page)).toBeFocused();
  await page.keyboard.type('11 03 00 6B 00 03 76 87', { delay: 5 });
  await bytes(page, '11 03 00 6B 00 03 76 87');
  await page.keyboard.press('Shift+Enter');
  await expect(text(page)).toHaveValue('11 03 00 6B 00 03 76 87\n');
  await page.keyboard.press('Enter');
  await expect(text(page)).toHaveValue('11 03 00 6B 00 03 76 87\n');
  await page.keyboard.press('Escape');
  await expect(text(page)).not.toBeFocused();
  await page.goBack();
  await bytes(page, '06 06 02 AB 10 00 F5 E5');
  await expect(text(page)).toHaveValue('');
});

test('a page with a link leaves the focus alone; Ctrl+K goes to the input, and a paste takes the place of its text', async ({
  page,
}) => {
  await open(page, '#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
  await expect(text(page)).not.toBeFocused();
  await paste(page, '06 06 02 AB 10 00 F5 E5');
  await page.keyboard.press('Control+k');
  await expect(text(page)).toBeFocused();
  await page.evaluate(() => navigator.clipboard.writeText('11 03 00 6B 00 03 76 87'));
  await page.keyboard.press('Control+V');
  await expect(text(page)).toHaveValue('11 03 00 6B 00 03 76 87');
  await bytes(page, '11 03 00 6B 00 03 76 87');
});

test('a chip puts its text into the input; the one with a log opens it, and its six faults are found by six keys', async ({
  page,
}) => {
  await open(page);
  await page.getByRole('button', { name: input.chips['wrong-crc'] }).click();
  await expect(text(page)).toHaveValue('06 06 02 AB 10 00 E6 A1');
  await bytes(page, '06 06 02 AB 10 00 E6 A1');
  await page.getByRole('button', { name: input.chips['faulty-log'] }).click();
  const list = page.getByRole('listbox');
  await expect(list).toHaveAccessibleName('200 frames');
  const found: string[] = [];
  for (let key = 0; key < 6; key++) {
    await page.keyboard.press('F8');
    const chosen = list.getByRole('option', { selected: true });
    await expect.poll(() => chosen.getAttribute('aria-posinset')).not.toBe(found.at(-1) ?? null);
    found.push((await chosen.getAttribute('aria-posinset')) ?? '');
  }
  expect(found).toEqual(['36', '63', '93', '121', '149', '182']);
  await page.goBack();
  await expect(text(page)).toHaveValue('06 06 02 AB 10 00 E6 A1');
});

test('a text without bytes leaves the frame before it, and no verdict says that all is well', async ({ page }) => {
  await open(page);
  await paste(page, '06 06 02 AB 10 00 F5 E5');
  await expect(page.getByRole('main')).toContainText('Valid');
  await paste(page, 'hello world');
  await expect(page.getByText(words.problems['no-bytes']({} as never))).toBeVisible();
  await bytes(page, '06 06 02 AB 10 00 F5 E5');
  await expect(page.getByText(/^Valid/)).toHaveCount(0);
  await page.goBack();
  await expect(text(page)).toHaveValue('06 06 02 AB 10 00 F5 E5');
  await expect(page.getByText(/^Valid/)).toBeVisible();
});

test('a frame that is pasted into a field for a number is offered there, and the field stays as it was', async ({
  page,
}) => {
  await open(page);
  const unit = new FrameForm(page).field('unitId');
  await page.evaluate(() => navigator.clipboard.writeText('11 03 00 6B 00 03 76 87'));
  await unit.focus();
  await page.keyboard.press('Control+V');
  const offer = page.getByRole('button', { name: readAsFrame });
  await expect(offer).toBeFocused();
  await expect(unit).toHaveValue('6');
  await page.keyboard.press('Escape');
  await expect(offer).toHaveCount(0);
  await expect(unit).toBeFocused();
  await page.keyboard.press('Control+V');
  await offer.click();
  await bytes(page, '11 03 00 6B 00 03 76 87');
  await expect(unit).toHaveValue('17');
  // One number is typed there as ever.
  await page.evaluate(() => navigator.clipboard.writeText('9'));
  await unit.fill('');
  await unit.press('Control+V');
  await expect(unit).toHaveValue('9');
});

test('a paste anywhere is read, says why it fails, and is replaced by the repaired frame', async ({ page }) => {
  await open(page);
  await paste(page, 'The guide prints 06 06 02 AB 10 00 E6 A1 for 30 Hz.');
  await expect(text(page)).toHaveValue('The guide prints 06 06 02 AB 10 00 E6 A1 for 30 Hz.');
  await bytes(page, '06 06 02 AB 10 00 E6 A1');
  await expect(frame(page)).toContainText('WEG guide');
  await frame(page).getByRole('button', { name: 'Use F5 E5' }).click();
  await bytes(page, '06 06 02 AB 10 00 F5 E5');
  await expect(page.getByText(/^RTU request/)).toBeVisible();
  await page.goBack();
  await bytes(page, '06 06 02 AB 10 00 E6 A1');
});

test('a log becomes a list, and a reply is explained with the addresses of its request', async ({ page }) => {
  await open(page);
  await paste(page, log);
  const list = page.getByRole('listbox');
  await expect(list.getByRole('option')).toHaveCount(4);
  await expect(list.getByRole('option').nth(1)).toContainText('10:31:12.316');
  await expect(list.getByRole('option').nth(1)).toContainText('reply');
  await list.getByRole('option').nth(1).click();
  await bytes(page, '01 03 04 02 2B 00 00 8B 83');
  await expect(new FrameForm(page).explanation).toContainText('Register 40108 (address 107) = 555 (0x022B)');
  await list.focus();
  await page.keyboard.press('End');
  await bytes(page, '01 83 02 C0 F1');
  await page.keyboard.press('ArrowUp');
  await bytes(page, '01 03 00 00 00 04 44 09');
});

test('what is ambiguous is said, and read the other way at one click', async ({ page }) => {
  await open(page);
  await paste(page, '1, 3, 0, 22, 0, 2, 37, 207');
  await expect(page.getByText(words.readAs('decimal'))).toBeVisible();
  await bytes(page, '01 03 00 16 00 02 25 CF');
  await paste(page, '10 11 12 13 14');
  await expect(page.getByText(words.readAs('hex'))).toBeVisible();
  await page.getByRole('button', { name: words.choose('decimal') }).click();
  await bytes(page, '0A 0B 0C 0D 0E');
});

test('what cannot be read is named with its place, and the rest is read', async ({ page }) => {
  await open(page);
  await paste(page, '[1, 3, 0, 300, 0, 2]');
  await expect(page.getByText(words.problems['value-over-255']({ got: 300 } as never))).toBeVisible();
  await page.getByRole('button', { name: words.line(1, 11) }).click();
  const selected = await text(page).evaluate((area: HTMLTextAreaElement) =>
    area.value.slice(area.selectionStart, area.selectionEnd),
  );
  expect(selected).toBe('300');
  await bytes(page, '01 03 00 00 02');
});

test('the same bytes are read as another kind of frame at one click', async ({ page }) => {
  await open(page);
  await paste(page, '06 06 02 AB 10 00 F5 E5');
  await expect(page.getByText(/^RTU request/)).toBeVisible();
  await page.getByRole('button', { name: words.readSo('RTU reply') }).click();
  await expect(page.getByText(/^RTU reply/)).toBeVisible();
  await bytes(page, '06 06 02 AB 10 00 F5 E5');
});

test('a text that is dropped is read; a reload keeps it', async ({ page }) => {
  await open(page);
  await page.evaluate((content) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], 'bus.txt', { type: 'text/plain' }));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, log);
  await expect(page.getByRole('listbox').getByRole('option')).toHaveCount(4);
  await page.goBack();
  await page.reload();
  await expect(text(page)).toHaveValue(log);
  await bytes(page, '01 03 00 6B 00 02 B5 D7');
});

test('a frame that users asked about gets its finding: one of each transport, with a request, and merged', async ({
  page,
}) => {
  await open(page);
  const kindOf = ({ transport, answering, finding }: UserFrame) =>
    finding === 'merged' ? finding : answering === undefined ? transport : `${transport} in answer`;
  const chosen = [...new Map(userFrames.map((frame) => [kindOf(frame), frame])).values()];
  expect(chosen.length).toBeGreaterThan(4);
  for (const { id, transport, pasted, pastedIsProse, hex, answering, finding } of chosen) {
    await open(page);
    await paste(page, answering === undefined ? (pastedIsProse ? hex : pasted) : `Tx: ${answering}\nRx: ${hex}`);
    if (answering !== undefined) {
      // A pair is shown in the strip; what is not one is a log.
      const inLog = page.getByRole('listbox').getByRole('option').last();
      await strip(page).getByRole('button', { name: 'Reply', exact: true }).or(inLog).first().click();
    }
    // What was merged is taken apart.
    if (finding === 'merged') {
      await expect(page.getByText(/\d bytes, 2 frames/), id).toBeVisible();
      continue;
    }
    const request = answering === undefined ? undefined : fromHex(answering.replaceAll(' ', ''));
    const expected = diagnose(fromHex(hex.replaceAll(' ', ''))!, {
      ...(transport !== 'data' && { transport }),
      request,
    });
    expect(expected[0]?.code, id).toBe(finding);
    // The strip shows characters as such.
    if (transport !== 'ascii') await bytes(page, hex, id);
    if (findingKinds[expected[0]!.code] === 'sound') continue;
    await why(page).click();
    await expect(page.getByRole('dialog').getByRole('heading', { level: 3 }).first(), id).toContainText(
      findingWords(expected[0]!).title,
    );
    await page.keyboard.press('Escape');
  }
});

test('a paste in the reference shows the frame, and Back returns to the reference', async ({ page }) => {
  await open(page);
  await page.getByRole('link', { name: 'Reference' }).click();
  await expect(page.getByRole('searchbox')).toBeVisible();
  await paste(page, '11 03 00 6B 00 03 76 87');
  await bytes(page, '11 03 00 6B 00 03 76 87');
  await page.goBack();
  await expect(page).toHaveURL(/#reference$/);
  await expect(page.getByRole('searchbox')).toBeVisible();
  await page.goForward();
  await bytes(page, '11 03 00 6B 00 03 76 87');
});

test('a long text is shown by its beginning; one that is longer still is opened as a log, and the frame stays', async ({
  page,
}) => {
  await open(page);
  const long = `${log}\n`.repeat(200);
  await paste(page, long);
  await expect(page).toHaveURL(/#log$/);
  await page.goBack();
  await expect(page.getByText(input.beginning(long.length))).toBeVisible();
  expect((await text(page).inputValue()).length).toBeLessThan(10_000);
  const first = '01 03 00 6B 00 02 B5 D7';
  await bytes(page, first);
  await paste(page, `${log}\n`.repeat(40_000));
  await expect(page.getByText('160,000 frames, ')).toBeVisible();
  await page.goBack();
  await expect(page.getByText(input.beginning(long.length))).toBeVisible();
  await bytes(page, first);
});
