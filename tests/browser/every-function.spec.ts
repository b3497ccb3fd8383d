import { readFileSync } from 'node:fs';
import { languages } from '../../src/words/index.ts';
import { FrameForm, type VectorFrame } from './form.ts';
import { expect, test } from './page.ts';

const en = await languages.en.page();

const frames: VectorFrame[] = JSON.parse(readFileSync('tests/vectors/frames.json', 'utf8'));

/** Longer ones differ from these in nothing but the number of the same controls. */
const LONGEST = 160;

/** One frame of each function, MEI type, sub-function and direction. */
function oneOfEach(transport: VectorFrame['transport']): VectorFrame[] {
  const found = new Map<string, VectorFrame>();
  for (const frame of frames) {
    if (frame.transport !== transport || frame.hex.length > LONGEST) continue;
    const { meiType, subFunction } = frame.fields;
    const key = [frame.functionCode, frame.direction, meiType, subFunction].join();
    if (!found.has(key)) found.set(key, frame);
  }
  return [...found.values()];
}

const typed = oneOfEach('rtu');
const requests = typed.filter(({ direction }) => direction === 'request');
const even = (_: unknown, index: number) => index % 2 === 0;
const odd = (_: unknown, index: number) => index % 2 === 1;
// Every other reply: that all frames come through the form's own code is tested without a browser.
const replies = typed.filter(({ direction }) => direction === 'response').filter(even);

for (const [what, chosen] of [
  ['requests, half 1', requests.filter(even)],
  ['requests, half 2', requests.filter(odd)],
  ['replies', replies],
] as const) {
  test(`every function typed into the form gives its bytes: ${what}`, async ({ page }) => {
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

test('a link to each function fills the form, over the other transports in turn', async ({ page }) => {
  const others = (['ascii', 'tcp', 'pdu'] as const).map(oneOfEach);
  const chosen = others.flatMap((all, turn) => all.filter((_, index) => index % others.length === turn));
  expect(chosen.length).toBeGreaterThan(25);
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
