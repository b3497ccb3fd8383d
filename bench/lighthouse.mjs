// What Lighthouse says of the built page, as a phone and as a computer: the median of five.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { findInstalledBrowser } from '../scripts/find-browser.mjs';
import { root, runNpm } from '../scripts/run.mjs';
import { load, printTable, servePage, waitForCalm } from './built-page.mjs';
import { quantile } from './quantile.mjs';

const RUNS = Number(process.env.RUNS ?? 5);
const kinds = [
  { name: 'desktop', performance: 98 },
  { name: 'mobile', performance: 95 },
];
const others = ['accessibility', 'best-practices', 'seo'];

if (!existsSync(join(root, 'bench/node_modules/lighthouse'))) {
  console.log('Installing Lighthouse into bench/ …');
  if ((await runNpm(['ci', '--prefix', 'bench', '--no-audit', '--no-fund'])) !== 0) process.exit(1);
}
const { default: lighthouse, desktopConfig } = await import('lighthouse');
const { launch } = await import('chrome-launcher');

const server = await servePage();
const calm = await waitForCalm();
const chromePath = findInstalledBrowser();
const browser = await launch({
  ...(chromePath && { chromePath }),
  chromeFlags: ['--headless=new', ...(process.getuid?.() === 0 ? ['--no-sandbox'] : [])],
});
const rows = [['as', 'performance', ...others, 'first paint', 'largest', 'blocked', 'shift', '']];
const lost = new Map();
let met = true;
for (const { name, performance } of kinds) {
  const runs = [];
  for (let n = 0; n < RUNS; n++) {
    const { lhr } = await lighthouse(
      server.address,
      { port: browser.port, logLevel: 'error', output: 'json' },
      name === 'desktop' ? desktopConfig : undefined,
    );
    if (lhr.runtimeError) throw new Error(lhr.runtimeError.message);
    runs.push(lhr);
    for (const [id, { auditRefs }] of Object.entries(lhr.categories)) {
      for (const { id: audit, weight } of auditRefs) {
        const { score, title, displayValue } = lhr.audits[audit];
        if (weight > 0 && score !== null && score < 0.9) lost.set(`${name}, ${id}: ${title}`, displayValue ?? '');
      }
    }
  }
  const median = (of) => quantile(runs.map(of), 0.5);
  const score = (category) => Math.round(median(({ categories }) => categories[category].score) * 100);
  const metric = (audit) => median(({ audits }) => audits[audit].numericValue);
  const keeps = score('performance') >= performance && others.every((category) => score(category) === 100);
  met &&= keeps;
  rows.push([
    name,
    `${score('performance')} of ${performance}`,
    ...others.map(score),
    `${Math.round(metric('first-contentful-paint'))} ms`,
    `${Math.round(metric('largest-contentful-paint'))} ms`,
    `${Math.round(metric('total-blocking-time'))} ms`,
    metric('cumulative-layout-shift').toFixed(3),
    keeps ? 'met' : 'NOT MET',
  ]);
}
browser.kill();
server.close();

console.log(
  `Lighthouse, median of ${RUNS}; load of the machine ${load().toFixed(1)}${calm ? '' : ': NOT CALM, performance comes out too low'}.\n`,
);
printTable(rows);
if (lost.size > 0)
  console.log(`\nWhere points were lost:\n${[...lost].map(([what, value]) => `  ${what} ${value}`).join('\n')}`);
process.exit(met ? 0 : 1);
