// Every view in every state, at every size, light and dark: contact sheets in .shots/, and the faults of its layout as a
// script finds them. `npm run shots -- frame drawer` does only what has these words in its view, state or size.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { root } from '../scripts/run.mjs';
import { launch, load, modulesOfThePage, printTable, servePage } from './built-page.mjs';
import { viewsOf } from './shots/states.mjs';

const sizes = [
  [320, 640],
  [390, 844],
  [700, 450],
  [1024, 768],
  [1280, 720],
  [1400, 900],
  [2560, 1300],
].map(([width, height]) => ({ width, height, name: `${width}×${height}` }));
const themes = ['light', 'dark'];
/** Sizes at which each control is given the focus once, and at which what comes first is to be in sight. */
const focusAt = [390, 1280];
const firstAt = 1280;
/** Sizes at which axe examines the page, with all its rules in the first theme, with those of colours in the other. */
const axeAt = 1280;
const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const ofColours = ['color-contrast', 'link-in-text-block'];

const wanted = process.argv.slice(2);
const isWanted = (...names) => wanted.every((word) => names.some((name) => name.includes(word)));
const folder = join(root, '.shots');

const { words, layoutFaults } = await modulesOfThePage();
const server = await servePage();
const browser = await launch();
mkdirSync(folder, { recursive: true });

/** @type {Map<string, { at: Set<string>, kind: string, what: string, view: string, states: Set<string> }>} */
const faults = new Map();
function note(view, state, at, kind, what) {
  // One fault in many states is one fault.
  const key = `${view} ${kind} ${what.replace(/\d+(\.\d+)?( ?px| %|×)/g, '')}`;
  const fault = faults.get(key) ?? { view, kind, what, at: new Set(), states: new Set() };
  fault.at.add(at);
  fault.states.add(state);
  faults.set(key, fault);
}

async function axe(page, theme) {
  if (!(await page.evaluate(() => 'axe' in globalThis))) await page.evaluate(axeSource);
  const how = theme === themes[0] ? {} : { runOnly: ofColours };
  const { violations } = await page.evaluate(
    (options) => globalThis.axe.run('html', { ...options, resultTypes: ['violations'] }),
    how,
  );
  return violations.map(
    ({ id, nodes }) =>
      `${id}: ${nodes
        .map(({ html }) => html.slice(0, 110))
        .slice(0, 3)
        .join(' ')}`,
  );
}

/** Sets one state up and looks at it in each size and theme. Answers its pictures, a theme each. */
async function lookAt(view, state) {
  const shots = { light: [], dark: [] };
  const context = await browser.newContext({
    viewport: sizes[4],
    permissions: ['clipboard-read', 'clipboard-write'],
    bypassCSP: true,
  });
  const page = await context.newPage();
  page.on('pageerror', (error) => note(view, state.name, '', 'thrown', error.message));
  page.on('console', (message) => {
    if (['warning', 'error'].includes(message.type()))
      note(view, state.name, '', 'console', message.text().slice(0, 160));
  });
  page.setDefaultTimeout(10_000);
  await page.goto(server.address + (state.at === undefined ? '' : `#${state.at}`));
  await page.locator('main').waitFor();
  try {
    await state.act?.(page);
    await page.waitForTimeout(300);
  } catch (error) {
    note(view, state.name, '', 'state not reached', error.message.split('\n')[0]);
  }
  for (const size of sizes) {
    if (!isWanted(view, state.name, size.name)) continue;
    await page.setViewportSize(size);
    await page.evaluate(() => scrollTo(0, 0));
    await page.waitForTimeout(120);
    for (const theme of themes) {
      await page.emulateMedia({ colorScheme: theme });
      if (theme === themes[0]) {
        const rules = {
          strip: words.page.page.bytes,
          focus: false,
          first: state.first && size.width === firstAt ? { form: 'form.build' } : undefined,
        };
        const found = await page.evaluate(layoutFaults, rules);
        for (const { kind, what } of found) note(view, state.name, size.name, kind, what);
      }
      if (size.width === axeAt) {
        for (const what of await axe(page, theme)) note(view, state.name, `${size.name} ${theme}`, 'axe', what);
      }
      const height = Math.round(size.height * 1.6);
      const png = await page.screenshot({
        clip: { x: 0, y: 0, width: size.width, height },
        fullPage: true,
        type: 'jpeg',
        quality: 70,
      });
      shots[theme].push({ png: png.toString('base64'), caption: `${state.name}, ${size.name}` });
    }
    await page.emulateMedia({ colorScheme: 'light' });
    // Last, since what has the focus may open something.
    if (state.focus && focusAt.includes(size.width)) {
      const found = await page.evaluate(layoutFaults, { strip: words.page.page.bytes, focus: true });
      for (const { kind, what } of found) {
        if (kind === 'under the strip') note(view, state.name, size.name, kind, what);
      }
    }
  }
  await context.close();
  return shots;
}

/** Puts pictures beside each other, a row a state. */
async function sheet(name, rows) {
  const page = await browser.newPage({ viewport: { width: 2200, height: 800 } });
  const cell = ({ png, caption }) =>
    `<figure><img src="data:image/jpeg;base64,${png}"><figcaption>${caption}</figcaption></figure>`;
  await page.setContent(
    `<style>body{margin:8px;background:#888;font:12px sans-serif;color:#fff}div{display:flex;gap:8px;align-items:start;margin-bottom:12px}
    figure{margin:0;flex:1 1 0;min-width:0}img{width:100%;display:block}</style>${rows
      .map((shots) => `<div>${shots.map(cell).join('')}</div>`)
      .join('')}`,
  );
  await page
    .locator('img')
    .last()
    .evaluate((image) => image.decode());
  writeFileSync(join(folder, `${name}.png`), await page.screenshot({ fullPage: true }));
  await page.close();
}

const MOST_ROWS = 12;
let looked = 0;
for (const { view, states } of viewsOf(words)) {
  const rows = { light: [], dark: [] };
  for (const state of states) {
    if (!sizes.some(({ name }) => isWanted(view, state.name, name))) continue;
    const shots = await lookAt(view, state);
    for (const theme of themes) rows[theme].push(shots[theme]);
    looked += shots.light.length;
  }
  for (const theme of themes) {
    for (let from = 0; from < rows[theme].length; from += MOST_ROWS) {
      const part = rows[theme].length > MOST_ROWS ? `-${from / MOST_ROWS + 1}` : '';
      await sheet(`${view}-${theme}${part}`, rows[theme].slice(from, from + MOST_ROWS));
    }
  }
}
await browser.close();
server.close();

const sorted = [...faults.values()].sort((a, b) => a.view.localeCompare(b.view) || a.kind.localeCompare(b.kind));
if (sorted.length > 0) {
  printTable([
    ['view', 'fault', 'sizes', 'states', 'what'],
    ...sorted.map(({ view, kind, at, states, what }) => [
      view,
      kind,
      [...at].slice(0, 3).join(' ') + (at.size > 3 ? ` +${at.size - 3}` : ''),
      [...states].slice(0, 2).join(', ') + (states.size > 2 ? ` +${states.size - 2}` : ''),
      what,
    ]),
  ]);
}
console.log(`\n${looked} pictures of each theme in .shots/, ${sorted.length} faults, load ${load().toFixed(1)}`);
process.exit(sorted.length === 0 ? 0 : 1);
