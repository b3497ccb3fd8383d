import { spawnSync } from 'node:child_process';
import { launch } from 'puppeteer-core';

/** A page in an installed Firefox, by WebDriver BiDi; `undefined` if there is none. */
export async function openFirefox() {
  const found = ['firefox', 'firefox-esr'].find((name) => spawnSync(name, ['--version']).status === 0);
  if (found === undefined) return undefined;
  const executablePath = spawnSync('sh', ['-c', `command -v ${found}`], { encoding: 'utf8' }).stdout.trim();
  const browser = await launch({ browser: 'firefox', executablePath, headless: true, protocolTimeout: 600_000 });
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 900 });
  return {
    name: await browser.version(),
    /** The process of the browser. */
    pid: browser.process().pid,
    goto: (to) => page.goto(to),
    evaluate: (work, ...given) => page.evaluate(`(${work})(...${JSON.stringify(given)})`),
    setFile: async (selector, path) => (await page.$(selector)).uploadFile(path),
    press: (key) => page.keyboard.press(key),
    close: () => browser.close(),
  };
}
