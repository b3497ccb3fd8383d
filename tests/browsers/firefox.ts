import { launch } from 'puppeteer-core';
import type { Browser, Tab } from './tab.ts';

/** Firefox, by WebDriver BiDi. */
export async function openFirefox(executablePath: string): Promise<Browser> {
  const browser = await launch({ browser: 'firefox', executablePath, headless: true });
  return {
    name: 'Firefox',
    async open(): Promise<Tab> {
      const context = await browser.createBrowserContext();
      const page = await context.newPage();
      await page.setViewport({ width: 1280, height: 720 });
      return {
        goto: (url) => page.goto(url).then(() => undefined),
        run: (fn, ...args) =>
          page.evaluate(`(${String(fn)})(...${JSON.stringify(args)})`) as ReturnType<Tab['run']> as never,
        click: (selector) => page.click(selector),
        type: (text) => page.keyboard.type(text),
        press: (key) => page.keyboard.press(key),
        async attach(selector, path) {
          const field = await page.$(selector);
          await (field as Awaited<ReturnType<typeof page.$<'input'>>>)?.uploadFile(path);
        },
        reload: () => page.reload().then(() => undefined),
        back: () => page.goBack().then(() => undefined),
        close: () => context.close(),
      };
    },
    close: () => browser.close(),
  };
}
