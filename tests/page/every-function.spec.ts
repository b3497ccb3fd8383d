import { readFileSync } from 'node:fs';
import { languages } from '../../src/words/index.ts';
import { FrameForm, type VectorFrame } from '../browser/form.ts';
import { expect, test } from './page.ts';

const en = await languages.en.page();

const frames: VectorFrame[] = JSON.parse(readFileSync('tests/vectors/frames.json', 'utf8'));

/** Longer ones differ from these in nothing but the number of the same controls. */
const LONGEST = 160;

/** The names of a frame's fields, those of its groups too. */
const fieldsOf = (fields: object): string[] =>
  Object.entries(fields).flatMap(([name, value]) => {
    const [first] = Array.isArray(value) ? value : [];
    return typeof first === 'object' ? [name, ...fieldsOf(first).map((inner) => `${name}.${inner}`)] : [name];
  });

/**
 * So many frames that each field of any function is in one of them: all functions share the controls. That every frame
 * comes through the form’s own code is tested without the page.
 */
function withEachField(transport: VectorFrame['transport'], direction: VectorFrame['direction']): VectorFrame[] {
  const seen = new Set<string>();
  return frames
    .filter((frame) => frame.transport === transport && frame.direction === direction && frame.hex.length <= LONGEST)
    .toSorted((a, b) => fieldsOf(b.fields).length - fieldsOf(a.fields).length)
    .filter(({ fields }) => {
      const added = fieldsOf(fields).filter((name) => !seen.has(name));
      for (const name of added) seen.add(name);
      return added.length > 0;
    });
}

for (const direction of ['request', 'response'] as const) {
  test(`every field of any ${direction} is typed into the form, and gives its bytes`, async ({ page }) => {
    const chosen = withEachField('rtu', direction);
    expect(chosen.length).toBeGreaterThan(8);
    await page.goto('./');
    const form = new FrameForm(page);
    for (const frame of chosen) {
      await test.step(frame.id, async () => {
        await form.fill(frame);
        // What is copied costs more to ask than what the strip shows, which cuts long lists.
        const pairs = frame.hex.match(/../g)!;
        await (pairs.length > 16
          ? form.expectCopied(frame.hex, frame.id)
          : form.expectBytes(pairs.join(' '), frame.id));
        await expect(page.getByText(/^(Valid|Doubtful) /)).toBeVisible();
      });
    }
  });
}

test('a link fills every field of the form, over the other transports in turn', async ({ page }) => {
  const chosen = [
    ...withEachField('ascii', 'request'),
    ...withEachField('tcp', 'response'),
    ...withEachField('pdu', 'request').slice(0, 3),
  ];
  expect(chosen.length).toBeGreaterThan(20);
  await page.goto('./');
  const form = new FrameForm(page);
  for (const frame of chosen) {
    await test.step(frame.id, async () => {
      await form.open(frame);
      await expect(page.getByText(/^(Valid|Doubtful) /)).toBeVisible();
      for (const name of Object.keys(frame.fields)) {
        const field = form.field(name).or(page.getByRole('group', { name: en.labels[name]!, exact: true }));
        await expect(field.first()).toBeVisible();
      }
      await form.expectCopied(frame.hex, frame.id);
    });
  }
});

test('a number too large to be exact is refused in every field, typed or in a link', async ({ page }) => {
  const main = page.getByRole('main');
  // 2 to the power of 53, all bits of 64, and more digits than a number has.
  const large = ['9007199254740992', '0xFFFFFFFFFFFFFFFF', '9'.repeat(400)];
  await page.goto('./');
  const form = new FrameForm(page);
  const fields = page.getByRole('form', { name: en.page.build }).getByRole('textbox');
  for (const frame of [...withEachField('tcp', 'request'), ...withEachField('rtu', 'response')]) {
    await form.open(frame);
    await expect(fields.first()).toBeVisible();
    const count = await fields.count();
    for (let at = 0; at < count; at += 1) {
      const field = fields.nth(at);
      const before = await field.inputValue();
      for (const number of large) {
        await field.fill(number);
        await expect(field, frame.id).toHaveValue(number);
        await expect(main, frame.id).toBeVisible();
      }
      await field.fill(before);
    }
  }
  for (const number of large) {
    for (const part of ['unitId', 'startAddress', 'quantity', 'force.checksum', 'functionCode']) {
      await page.goto(`./#rtu/request?functionCode=3&${part}=${number}`);
      await expect(page.getByRole('region', { name: 'The frame' }), part).toBeVisible();
    }
  }
});
