import { type ChildProcess, spawn } from 'node:child_process';
import type { AddressInfo } from 'node:net';
import { createServer } from 'node:net';
import type { Browser, Key, Tab } from './tab.ts';

/** WebDriver's codes of keys. */
const KEYS: Readonly<Record<Key, string>> = {
  Enter: '\uE007',
  Escape: '\uE00C',
  Tab: '\uE004',
  F8: '\uE038',
  ArrowDown: '\uE015',
};

/** How long a command may take, in milliseconds. */
const ANSWERS = 40_000;

/** WebDriver's name for the reference to an element. */
const ELEMENT = 'element-6066-11e4-a52e-4f735466cecf';

/**
 * WebKitGTK, by WebDriver, on a screen of its own.
 * @param driver the path of WebKitWebDriver
 * @param window the path of MiniBrowser, which WebKitGTK brings along
 */
export async function openWebKit(driver: string, window: string): Promise<Browser> {
  const screen = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1400x1000x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const display = await firstLine(screen);
  const port = await freePort();
  const service = spawn(driver, [`--port=${port}`], {
    // Its language is `C` then, which is no language tag.
    env: {
      ...process.env,
      LANG: 'C',
      LANGUAGE: '',
      LC_ALL: 'C',
      DISPLAY: `:${display}`,
      LIBGL_ALWAYS_SOFTWARE: '1',
      WEBKIT_DISABLE_COMPOSITING_MODE: '1',
    },
    stdio: 'ignore',
  });
  const call = async (method: string, path: string, body?: unknown): Promise<unknown> => {
    const answer = await fetch(`http://127.0.0.1:${port}${path}`, {
      method,
      // It stops answering now and then; a step that fails for that is told from one that fails by itself.
      signal: AbortSignal.timeout(ANSWERS),
      ...(method === 'POST' && { body: JSON.stringify(body ?? {}) }),
    });
    const { value } = (await answer.json()) as { value: { error?: string; message?: string } | null };
    if (value?.error !== undefined) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  await listens(() => call('GET', '/status'));
  return {
    name: 'WebKitGTK',
    async open(): Promise<Tab> {
      const { sessionId } = (await call('POST', '/session', {
        capabilities: {
          alwaysMatch: { 'webkitgtk:browserOptions': { binary: window, args: ['--automation'] } },
        },
      })) as { sessionId: string };
      const session = `/session/${sessionId}`;
      await call('POST', `${session}/window/rect`, { width: 1280, height: 900 });
      const find = async (selector: string) => {
        const found = (await call('POST', `${session}/element`, { using: 'css selector', value: selector })) as Record<
          string,
          string
        >;
        return `${session}/element/${found[ELEMENT]}`;
      };
      const type = async (text: string) => {
        const actions = [...text].flatMap((value) => [
          { type: 'keyDown', value },
          { type: 'keyUp', value },
        ]);
        await call('POST', `${session}/actions`, { actions: [{ type: 'key', id: 'keys', actions }] });
      };
      return {
        goto: (url) => call('POST', `${session}/url`, { url }).then(() => undefined),
        run: (fn, ...args) =>
          call('POST', `${session}/execute/sync`, { script: `return (${String(fn)})(...arguments)`, args }) as never,
        click: async (selector) => void (await call('POST', `${await find(selector)}/click`)),
        type,
        press: (key) => type(KEYS[key]),
        attach: async (selector, path) => void (await call('POST', `${await find(selector)}/value`, { text: path })),
        reload: () => call('POST', `${session}/refresh`).then(() => undefined),
        back: () => call('POST', `${session}/back`).then(() => undefined),
        close: () => call('DELETE', session).then(() => undefined),
      };
    },
    async close() {
      service.kill();
      screen.kill();
    },
  };
}

function firstLine(program: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    program.once('error', reject);
    program.stdio[3]?.once('data', (data) => resolve(String(data).trim()));
  });
}

function freePort(): Promise<number> {
  return new Promise((resolve) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    });
  });
}

async function listens(ask: () => Promise<unknown>): Promise<void> {
  for (let tries = 0; ; tries++) {
    try {
      await ask();
      return;
    } catch (error) {
      if (tries > 100) throw error;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
}
