import { launch } from 'puppeteer-core';
import type { Browser, Tab } from './tab.ts';

interface Firefox extends Browser {
  /** Waits until the browser asks which serial port a page may have, and allows the one of this name. */
  allowPort(name: string): Promise<void>;
}

/** WebDriver BiDi, as far as the browser's own windows are spoken to. */
interface Bidi {
  send(method: 'browsingContext.getTree', given: object): Promise<{ result: { contexts: { context: string }[] } }>;
  send(method: 'script.evaluate', given: object): Promise<{ result: { result?: { value?: unknown } } }>;
}

/**
 * Firefox, by WebDriver BiDi.
 * @param more what is in its environment besides
 */
export async function openFirefox(executablePath: string, more: NodeJS.ProcessEnv = {}): Promise<Firefox> {
  const browser = await launch({
    browser: 'firefox',
    executablePath,
    headless: true,
    args: ['--remote-allow-system-access'],
    env: { ...process.env, ...more },
  });
  const { connection } = browser as unknown as { connection: Bidi };
  return {
    name: 'Firefox',
    async allowPort(name) {
      for (let tries = 0; ; tries++) {
        const { contexts } = (await connection.send('browsingContext.getTree', { 'moz:scope': 'chrome' })).result;
        const asked = contexts.map(({ context }) =>
          connection.send('script.evaluate', {
            expression: `(${allow})(${JSON.stringify(name)})`,
            target: { context },
            awaitPromise: false,
          }),
        );
        const answers = await Promise.all(asked);
        if (answers.some(({ result }) => result.result?.value === true)) return;
        if (tries > 100) throw new Error(`The browser offers no port ${name}: ${JSON.stringify(answers)}`);
        await new Promise((resolve) => setTimeout(resolve, 200));
      }
    },
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

/** In the browser's own window: chooses a port in what asks for one, and allows it; whether that could be done. */
function allow(name: string): boolean {
  const ports = document.getElementById('webSerial-selectPort-menulist') as
    | (Element & { selectedIndex: number })
    | null;
  const labels = [...(ports?.querySelectorAll('menuitem') ?? [])].map((item) => item.getAttribute('label'));
  const asks = document.getElementById('webSerial-choosePort-notification') as
    | (Element & { button: HTMLElement })
    | null;
  if (!ports || !asks?.checkVisibility() || !labels.includes(name)) return false;
  ports.selectedIndex = labels.indexOf(name);
  asks.button.click();
  return true;
}
