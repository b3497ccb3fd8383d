import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { afterAll, beforeAll } from 'vitest';
import type { Language } from '../../src/words/index.ts';
import { allCame, expect, test } from './page.ts';

// Every sentence and label of the page comes from its language: the page has a planted one, in which all that is said
// stands between ⟦ and ⟧, and what stands outside of them is looked for.

test.use({ locale: 'qps' });

function marked(said: unknown): unknown {
  if (typeof said === 'string') return /\p{L}/u.test(said) ? `⟦${said}⟧` : said;
  if (typeof said === 'function') return (...args: unknown[]) => marked(said(...args));
  if (Array.isArray(said)) return said.map(marked);
  if (said instanceof Map) return new Map([...said].map(([key, value]) => [key, marked(value)]));
  if (typeof said !== 'object' || said === null) return said;
  const all = Object.create(Object.getPrototypeOf(said));
  for (const [key, value] of Object.entries(said)) all[key] = marked(value);
  return all;
}

/** Before each page: one more language, `qps`, which is English with every sentence between ⟦ and ⟧, also those that functions make. */
beforeAll(() => {
  const beforePage = (languages: Record<string, Language>) => {
    const subjects = Object.entries(languages['en'] as Language);
    const qps = Object.fromEntries(subjects.map(([subject, load]) => [subject, async () => marked(await load())]));
    Object.assign(languages, { qps });
  };
  Object.assign(globalThis, { beforePage });
});
afterAll(() => Reflect.deleteProperty(globalThis, 'beforePage'));

/** Names that the specification, devices, checksums and languages have everywhere: they are data of the layers below words. */
const names = new Set<string>(['Framewright']);
for (const layer of ['src/modbus', 'src/devices', 'src/sequences', 'src/codegen']) {
  for (const file of readdirSync(layer, { recursive: true, encoding: 'utf8' })) {
    if (!file.endsWith('.ts')) continue;
    for (const [, name = ''] of readFileSync(join(layer, file), 'utf8').matchAll(/'([^'\n]+)'/g)) names.add(name);
  }
}

/** What is written alike in every language. */
const alike = [
  // Numbers, ranges and rows of them: 0x1F, F8–FE, 7F AB.
  /^(0x)?[0-9A-F]+(–[0-9A-F]+)?$/,
  /^[0-9A-F]{2}( [0-9A-F]{2})*$/,
  // The sign of a note.
  /^i$/,
  // Formats of characters, types of values, memory of a controller, and what the transports are called.
  /^\d[NEO]\d$/,
  /^([uif]|bcd)\d+$/,
  /^[A-Z]+\d+ … [A-Z]+\d+$/,
  /^(RTU|ASCII|TCP|PDU)$/,
];

/** What of the page stands outside of the marks, as `element: text`. */
function unmarked(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const said = [
      'title',
      'aria-label',
      'aria-description',
      'aria-valuetext',
      'aria-roledescription',
      'placeholder',
      'alt',
      'label',
    ];
    const found: string[] = [];
    const look = (text: string | null, where: string) => {
      let outside = '';
      let depth = 0;
      for (const character of text ?? '') {
        if (character === '⟦') depth += 1;
        else if (character === '⟧') depth -= 1;
        else if (depth === 0) outside += character;
      }
      if (/\p{L}/u.test(outside)) found.push(`${where}: ${outside.trim()}`);
    };
    look(document.title, 'title of the window');
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT | NodeFilter.SHOW_ELEMENT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (node instanceof Element) {
        for (const name of said) look(node.getAttribute(name), `${name} of ${node.tagName.toLowerCase()}`);
      } else if (node.parentElement && !node.parentElement.closest('noscript, .unstyled, .mono, code, pre')) {
        look(node.textContent, node.parentElement.tagName.toLowerCase());
      }
    }
    return found;
  });
}

/** Fails for what is on the page and does not come from its language. */
async function expectSaid(page: Page): Promise<void> {
  await expect(page.locator('html')).toHaveAttribute('lang', 'qps');
  const found = (await unmarked(page)).filter((text) => {
    const outside = text.slice(text.indexOf(': ') + 2);
    // Of a list each name; functions and bits of a device have their number before it.
    return !outside.split(/,(?: |$)/).every((part) => {
      const name = part.replace(/^[0-9A-F]{1,2} /, '').replace(/ \(\)$/, '');
      return (
        !/\p{L}/u.test(name) || names.has(name) || names.has(outside) || alike.some((pattern) => pattern.test(name))
      );
    });
  });
  expect([...new Set(found)]).toEqual([]);
}

/** Opens every fold, those inside of others too. */
async function openAll(page: Page): Promise<void> {
  for (let round = 0; round < 4; round++) {
    const closed = await page.evaluate(() => {
      const folds = [...document.querySelectorAll<HTMLDetailsElement>('details:not([open])')];
      for (const fold of folds) fold.open = true;
      return folds.length;
    });
    await allCame(page);
    if (closed === 0) return;
  }
}

const places = [
  '#rtu/request?unitId=1&functionCode=3&startAddress=107&quantity=300&device=weg-cfw900',
  '#tcp/response?unitId=1&functionCode=3&registers=1+2',
  '#rtu/request?unitId=1&functionCode=16&startAddress=40108&registers=x',
  '#ascii/request?bytes=3A3031',
  '#rtu/request?unitId=x&functionCode=22&referenceAddress=4&andMask=0xF2&orMask=0x25&nothing=1',
  '#rtu/exception?unitId=1&functionCode=65&exceptionCode=2',
  '#rtu/request?unitId=6&functionCode=6&address=683&value=4096&device=weg-cfw900&tab=program&program=c.check',
  '#checksum?bytes=0A+0B',
  '#timing',
  '#bus',
  '#reference',
];

for (const place of places) {
  test(`all comes from the language of the page: ${place}`, async ({ page }) => {
    await page.goto(`./${place}`);
    await expect(page.getByRole('main')).toBeVisible();
    await openAll(page);
    await expectSaid(page);
  });
}

test('all comes from the language of the page: a log that is read, a device, the keys', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByRole('main')).toBeVisible();
  await openAll(page);
  await page
    .locator('textarea#input')
    .fill('TX 11 03 00 6B 00 03 76 87\nRX 11 03 06 02 2B 00 00 00 64 C8 BB\nRX 11 83 02 00 00 zz');
  await page.locator('.device-choice select').first().selectOption({ index: 1 });
  await openAll(page);
  await expectSaid(page);
  await page.keyboard.press('Control+/');
  await expect(page.getByRole('dialog')).toBeVisible();
  await expectSaid(page);
});

test('all comes from the language of the page: a program, and why a listing does not compile', async ({ page }) => {
  await page.goto(`./#tcp/request?v=5&unitId=1&functionCode=3&startAddress=1&quantity=2&tab=program`);
  await expect(page.locator('.program-options')).toBeVisible();
  await openAll(page);
  await page.locator('.program textarea').fill('nothing');
  await page.getByRole('button', { name: /listing/ }).click();
  await expect(page.getByRole('dialog')).toBeVisible();
  await expectSaid(page);
});

test('all comes from the language of the page: what is sent on the virtual bus', async ({ page }) => {
  await page.goto(`./#bus`);
  await openAll(page);
  await page
    .getByRole('button', { name: /virtual bus/i })
    .first()
    .click();
  await page.getByRole('button', { name: '⟦Send⟧' }).click();
  await expect(page.getByRole('region', { name: '⟦Current frame⟧' })).toContainText('⟦Not sent');
  await openAll(page);
  await expectSaid(page);
});
