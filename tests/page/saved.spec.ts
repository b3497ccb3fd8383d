import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { FrameForm } from '../browser/form.ts';
import { SavedFrames } from '../browser/saved-frames.ts';
import { expect, test } from './page.ts';

const KEY = 'framewright.saved-frames';
const READ = 'rtu/request?unitId=17&functionCode=3&startAddress=0x6B&quantity=3';

const stored = (page: Page) => page.evaluate((key) => localStorage.getItem(key), KEY);
const file = (frames: unknown, version = 1) => JSON.stringify({ format: 'framewright-frames', version, frames });

test('saved frames are copied at once, all or those that are chosen, each under a name of its own', async ({
  page,
}) => {
  const saved = new SavedFrames(page);
  await saved.open(`#${READ}`);
  for (const name of ['Read speed', 'read Speed', '7 bits']) await saved.save(name);
  await expect(saved.rows).toHaveCount(3);
  const clipboard = () => page.evaluate(() => navigator.clipboard.readText());
  const bytes = '0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87';
  const copy = async (button: string, format: RegExp) => {
    await saved.panel.getByRole('button', { name: button, exact: true }).click();
    await page.getByRole('menuitem', { name: format }).click();
  };
  await copy('Copy all 3 as', /^C c/);
  await expect
    .poll(clipboard)
    .toBe(
      ['read_speed', 'read_speed_2', 'frame_7_bits']
        .map((name) => `const uint8_t ${name}[8] = { ${bytes} };`)
        .join('\n'),
    );
  await saved.panel.getByRole('checkbox', { name: 'Choose Read speed', exact: true }).check();
  await saved.panel.getByRole('checkbox', { name: 'Choose 7 bits' }).check();
  await copy('Copy 2 chosen as', /^Structured Text/);
  const st = bytes.replaceAll('0x', '16#');
  await expect
    .poll(clipboard)
    .toBe(['ReadSpeed', 'Frame7Bits'].map((name) => `${name} : ARRAY[0..7] OF BYTE := [${st}];`).join('\n'));
  // A row is copied in the format copied last.
  await saved.panel.getByRole('button', { name: /^Copy\b.*7 bits/ }).click();
  await expect.poll(clipboard).toBe(`Frame7Bits : ARRAY[0..7] OF BYTE := [${st}];`);
});

test('a frame is saved, is there after a reload, and opens as one step', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open(`#${READ}`);
  await saved.save('  Read   three ');
  await expect(saved.said).toHaveText('Saved as “Read three”.');
  await expect(saved.page.getByLabel('Name of this frame')).toHaveValue('');
  await saved.open('#tcp/request?functionCode=4');
  await page.reload();
  await saved.show();
  await expect(saved.rows).toHaveCount(1);
  await expect(saved.rows).toContainText('11 03 00 6B 00 03 76 87');
  await expect(saved.names).toHaveAttribute('href', new RegExp(`#${READ.replace('?', '.')}$`));

  const form = new FrameForm(page);
  await saved.names.click();
  await form.expectCopied('1103006B00037687');
  await page.goBack();
  await expect(page.getByText(/^TCP request/)).toBeVisible();
  await page.goForward();
  await form.expectCopied('1103006B00037687');
});

test('an invalid draft is saved as typed', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open('#rtu/request?functionCode=6&value=abc');
  await saved.save('Broken');
  await expect(saved.rows).toContainText('No frame: 1 value cannot be sent.');
  await page.evaluate(() => {
    location.hash = '';
  });
  await saved.names.click();
  await expect(new FrameForm(page).field('value')).toHaveValue('abc');
});

test('a frame needs a name', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  for (const name of ['', '   ']) {
    await saved.save(name);
    await expect(page.getByLabel('Name of this frame')).toBeFocused();
    await expect(saved.rows).toHaveCount(0);
    expect(await stored(page)).toBeNull();
  }
});

test('a name that is taken keeps both frames, and it is said', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  await saved.save('Pump');
  await saved.save('Pump');
  await expect(saved.said).toHaveText('“Pump” is taken, and stays: the other is kept as “Pump (2)”.');
  await expect(saved.names).toHaveText(['Pump', 'Pump (2)']);
});

test('a frame is renamed from the keyboard, Escape leaves its name, and the focus stays near', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  await saved.save('Pump');
  await saved.save('Fan');
  await saved.button('Rename Pump').press('Enter');
  const input = page.getByLabel('New name of Pump');
  await expect(input).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(saved.button('Rename Pump')).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(input).toBeFocused();
  await page.keyboard.type('Valve');
  await page.keyboard.press('Enter');
  await expect(saved.said).toHaveText('Renamed to “Valve”.');
  await expect(saved.button('Rename Valve')).toBeFocused();
  await expect(saved.names).toHaveText(['Valve', 'Fan']);
  await saved.button('Rename Valve').click();
  await page.getByLabel('New name of Valve').fill('Fan');
  await saved.button('Keep').click();
  await expect(saved.names).toHaveText(['Fan (2)', 'Fan']);
});

test('deleted frames come back one by one, each to its place', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  for (const name of ['A', 'B', 'C']) await saved.save(name);
  await saved.button('Delete B').click();
  await expect(saved.said).toHaveText('“B” is deleted.');
  await expect(saved.button('Undo: bring B back')).toBeFocused();
  await saved.button('Delete A').click();
  await expect(saved.names).toHaveText(['C']);
  await saved.button('Undo: bring A back').click();
  await expect(saved.names.first()).toBeFocused();
  await saved.button('Undo: bring B back').click();
  await expect(saved.names).toHaveText(['A', 'B', 'C']);
  await page.reload();
  await saved.show();
  await expect(saved.names).toHaveText(['A', 'B', 'C']);
});

test('what is exported gives the same list in a browser that has none', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open(`#${READ}`);
  await expect(saved.button('Export all')).toBeDisabled();
  await saved.save('Read three');
  await page.evaluate(() => {
    location.hash = '#ascii/reply?functionCode=3&registers=1 2&answering=x&force.checksum=7';
  });
  await saved.save('Näme “q” 读 <b>');
  const downloading = page.waitForEvent('download');
  await saved.button('Export all').click();
  const download = await downloading;
  expect(download.suggestedFilename()).toBe('framewright-frames.json');
  await expect(saved.said).toHaveText('2 frames written to framewright-frames.json.');
  const text = readFileSync(await download.path(), 'utf8');

  const rows = await saved.rows.allTextContents();
  const kept = await stored(page);
  await page.evaluate(() => localStorage.clear());
  await page.reload();
  await saved.show();
  await expect(saved.rows).toHaveCount(0);
  await saved.import('frames.json', text);
  await expect(saved.said).toHaveText('2 frames imported.');
  await expect(saved.rows).toHaveText(rows);
  expect(await stored(page)).toBe(kept);

  await saved.import('frames.json', text);
  await expect(saved.said).toContainText('2 frames were here already, unchanged.');
  await expect(saved.rows).toHaveCount(2);

  await saved.import('one.json', file([{ name: 'Read three', link: READ }]));
  await expect(saved.said).toContainText('1 frame was here already, unchanged.');
});

test('an import takes the good rows, names the bad ones, and overwrites nothing', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  await saved.save('Pump');
  await saved.import(
    'mixed.json',
    file([{ name: 'Pump', link: READ }, { name: 'Fan', link: 'x/y' }, 7, { link: READ }]),
  );
  await expect(saved.said.getByRole('paragraph')).toHaveText([
    '1 frame imported.',
    '“Pump” is taken, and stays: the other is kept as “Pump (2)”.',
    'Not imported: row 2 has a link that means nothing here.',
    'Not imported: row 3 is not made of a name and a link.',
    'Not imported: row 4 has no name.',
  ]);
  await expect(saved.names).toHaveText(['Pump', 'Pump (2)']);
  await expect(saved.rows.nth(1)).toContainText('11 03 00 6B 00 03 76 87');
});

test('a file that is no list of saved frames imports nothing and says why', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  await saved.save('Pump');
  const before = await stored(page);
  for (const [what, text, why] of [
    ['no JSON', 'frames: none', 'Nothing imported from bad.json. It is not JSON: '],
    ['another JSON', '{"a": 1}', 'Nothing imported from bad.json. It is JSON, but not a list of saved frames.'],
    ['a newer file', file([], 2), 'Nothing imported from bad.json. It has version 2; this page knows version 1.'],
    ['too much', `"${'x'.repeat(5_000_001)}"`, 'Nothing imported from bad.json. It has more than 5 MB.'],
  ] as const) {
    await saved.import('bad.json', text);
    await expect(saved.said, what).toContainText(why);
    expect(await stored(page)).toBe(before);
  }
});

test('a storage that cannot be read is left alone, until it is set aside', async ({ page }) => {
  const broken = '{"format":"framewright-frames","version":1,"fra';
  await page.addInitScript(
    ([key, text]) => {
      if (sessionStorage.getItem('broken') === null) localStorage.setItem(key!, text!);
      sessionStorage.setItem('broken', 'done');
    },
    [KEY, broken] as const,
  );
  const saved = new SavedFrames(page);
  await saved.open();
  await expect(saved.panel).toContainText('What this browser stored under this page cannot be read. It is not JSON: ');
  await saved.save('Pump');
  await expect(saved.said).toHaveText('It is left as it is, and nothing is saved over it.');
  await expect(page.getByLabel('Name of this frame')).toHaveValue('Pump');
  expect(await stored(page)).toBe(broken);
  const downloading = page.waitForEvent('download');
  await saved.button('Download it').click();
  expect(readFileSync(await (await downloading).path(), 'utf8')).toBe(broken);

  await saved.button('Set it aside and start again').click();
  await expect(saved.said).toHaveText(`Set aside in the storage as “${KEY}.unreadable-1”.`);
  await saved.save('Pump');
  await expect(saved.names).toHaveText(['Pump']);
  expect(await page.evaluate((key) => localStorage.getItem(key), `${KEY}.unreadable-1`)).toBe(broken);
});

test('rows of the storage that cannot be read are named, and kept when others are saved', async ({ page }) => {
  await page.goto('./');
  await page.evaluate(
    ([key, text]) => localStorage.setItem(key!, text!),
    [
      KEY,
      file([
        { name: 'Pump', link: READ },
        { name: 'From tomorrow', link: 'can/request?x=1' },
      ]),
    ],
  );
  const saved = new SavedFrames(page);
  await page.reload();
  await saved.show();
  await expect(saved.panel).toContainText('Row 2 has a link that means nothing here.');
  await saved.save('Fan');
  await expect(saved.names).toHaveText(['Pump', 'Fan']);
  expect(await stored(page)).toContain('can/request?x=1');
});

test('a full storage changes nothing, and says so', async ({ page }) => {
  const saved = new SavedFrames(page);
  await saved.open();
  await saved.save('Pump');
  await page.evaluate(() => {
    let chunk = 'x'.repeat(1 << 20);
    for (let number = 0; chunk.length > 0; number++) {
      try {
        localStorage.setItem(`filler-${number}`, chunk);
      } catch {
        chunk = chunk.slice(0, chunk.length >> 1);
      }
    }
  });
  await saved.save('Fan');
  await expect(saved.said).toContainText('the storage that this browser gives the page is full. Nothing was changed.');
  await expect(page.getByLabel('Name of this frame')).toHaveValue('Fan');
  await expect(saved.names).toHaveText(['Pump']);
  await saved.import('more.json', file([{ name: 'Valve', link: READ }]));
  await expect(saved.names).toHaveText(['Pump']);
  await saved.button('Delete Pump').click();
  await expect(saved.rows).toHaveCount(0);
});

test('a browser that refuses storage says so, and the page works on', async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, 'localStorage', {
      get: () => {
        throw new DOMException('denied', 'SecurityError');
      },
    });
  });
  const saved = new SavedFrames(page);
  await saved.open(`#${READ}`);
  await expect(saved.panel).toContainText('this browser allows this page no storage');
  await saved.save('Pump');
  await expect(saved.said).toContainText('Nothing was changed.');
  await new FrameForm(page).expectCopied('1103006B00037687');
});
