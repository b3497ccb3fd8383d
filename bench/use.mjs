// How much people have to do for what they come for: clicks, fields typed, pastes and scrolls, and whether the result is right.
// `npm run bench:use -- 4 16` does some of the tasks.
import { launch, load, modulesOfThePage, printTable, servePage } from './built-page.mjs';
import { Person } from './use/person.mjs';
import { tasksOf } from './use/tasks.mjs';

const wanted = process.argv.slice(2).map(Number);
const { words } = await modulesOfThePage();
const server = await servePage();
const browser = await launch();
const counted = ['clicks', 'fields', 'pastes', 'scrolls'];

const rows = [['', 'task', ...counted, 'target', '']];
const faults = [];
for (const { number, name, target, run } of tasksOf(words)) {
  if (wanted.length > 0 && !wanted.includes(number)) continue;
  const context = await browser.newContext({
    viewport: { width: 1280, height: 720 },
    permissions: ['clipboard-read', 'clipboard-write'],
  });
  const page = await context.newPage();
  page.setDefaultTimeout(6000);
  await page.goto(server.address);
  await page.locator('main form').waitFor();
  const me = new Person(page);
  const wrong = [];
  const is = (what, got, expected) => {
    if (got !== expected) wrong.push(`${what}: ${JSON.stringify(got)}, not ${JSON.stringify(expected)}`);
  };
  try {
    await run({ me, page, is });
  } catch (error) {
    wrong.push(`not done: ${error.message.split('\n').slice(0, 4).join(' ').replace(/\s+/g, ' ')}`);
  }
  const over = counted.filter((what) => me[what] > (target[what] ?? Number.POSITIVE_INFINITY));
  const verdict = wrong.length > 0 ? 'WRONG' : over.length > 0 ? 'NOT MET' : 'met';
  const targets = Object.entries(target).map(([what, most]) => `${what} ≤ ${most}`);
  rows.push([number, name, ...counted.map((what) => me[what]), targets.join(', '), verdict]);
  faults.push(...wrong.map((what) => `  ${number} ${name}: ${what}`));
  if (process.env.PICTURES) await page.screenshot({ path: `${process.env.PICTURES}-${number}-${rows.length}.png` });
  await context.close();
}
await browser.close();
server.close();
printTable(rows);
if (faults.length > 0) console.log(`\n${faults.join('\n')}`);
const met = rows.slice(1).every((row) => row.at(-1) === 'met');
console.log(`\n${met ? 'Every target met' : 'Not every target met'}; window 1280×720, load ${load().toFixed(1)}`);
process.exit(met ? 0 : 1);
