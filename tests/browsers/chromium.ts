import { chromium } from '@playwright/test';
import type { Browser, Tab } from './tab.ts';

/** Chromium, by Playwright. */
export async function openChromium(executablePath: string): Promise<Browser> {
  const browser = await chromium.launch({ executablePath, args: process.getuid?.() === 0 ? ['--no-sandbox'] : [] });
  return {
    name: 'Chromium',
    async open(): Promise<Tab> {
      const context = await browser.newContext({ viewport: { width: 1280, height: 720 } });
      const page = await context.newPage();
      return {
        goto: (url) => page.goto(url).then(() => undefined),
        run: (fn, ...args) => page.evaluate(`(${String(fn)})(...${JSON.stringify(args)})`),
        click: (selector) => page.click(selector),
        type: (text) => page.keyboard.type(text),
        press: (key) => page.keyboard.press(key),
        attach: (selector, path) => page.setInputFiles(selector, path),
        reload: () => page.reload().then(() => undefined),
        back: () => page.goBack().then(() => undefined),
        close: () => context.close(),
      };
    },
    close: () => browser.close(),
  };
}
