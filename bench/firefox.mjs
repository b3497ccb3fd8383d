// Firefox over WebDriver BiDi, as far as a measurement needs it. https://w3c.github.io/webdriver-bidi/
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { WebSocket } from 'ws';

const NAMES = ['firefox', 'firefox-esr'];
const KEYS = { End: '\uE010', Home: '\uE011', ArrowDown: '\uE015', ArrowUp: '\uE013', PageUp: '\uE00E', F8: '\uE038' };

/** A page in an installed Firefox; `undefined` if there is none. */
export async function openFirefox() {
  const name = NAMES.find((one) => spawnSync(one, ['--version']).status === 0);
  if (name === undefined) return undefined;
  const profile = mkdtempSync(join(tmpdir(), 'framewright-firefox-'));
  const program = spawn(name, ['--headless', '--remote-debugging-port=0', '--profile', profile, '--no-remote'], {
    stdio: ['ignore', 'ignore', 'pipe'],
    env: { ...process.env, HOME: profile },
  });
  const url = await new Promise((resolve, reject) => {
    let said = '';
    program.stderr.setEncoding('utf8').on('data', (text) => {
      said += text;
      const found = /WebDriver BiDi listening on (ws:\S+)/.exec(said)?.[1];
      if (found) resolve(found);
    });
    program.on('exit', () => reject(new Error(`Firefox ended: ${said}`)));
  });
  const socket = new WebSocket(`${url}/session`);
  await new Promise((done) => socket.on('open', done));
  const waiting = new Map();
  let last = 0;
  socket.on('message', (data) => {
    const { id, type, result, message } = JSON.parse(String(data));
    const [resolve, reject] = waiting.get(id) ?? [];
    waiting.delete(id);
    if (type === 'success') resolve?.(result);
    else if (type === 'error') reject?.(new Error(message));
  });
  const send = (method, params = {}) =>
    new Promise((resolve, reject) => {
      waiting.set(++last, [resolve, reject]);
      socket.send(JSON.stringify({ id: last, method, params }));
    });
  const { capabilities } = await send('session.new', { capabilities: {} });
  const { contexts } = await send('browsingContext.getTree');
  const { context } = contexts[0];
  return {
    name: `Firefox ${capabilities.browserVersion}`,
    goto: (to) => send('browsingContext.navigate', { context, url: to, wait: 'complete' }),
    async evaluate(work, ...given) {
      const expression = `Promise.resolve((${work})(...${JSON.stringify(given)})).then((value) => JSON.stringify(value) ?? 'null')`;
      const { result, exceptionDetails } = await send('script.evaluate', {
        expression,
        target: { context },
        awaitPromise: true,
      });
      if (exceptionDetails) throw new Error(exceptionDetails.text);
      return JSON.parse(result.value);
    },
    async setFile(selector, path) {
      const locator = { type: 'css', value: selector };
      const { nodes } = await send('browsingContext.locateNodes', { context, locator });
      await send('input.setFiles', { context, element: { sharedId: nodes[0].sharedId }, files: [path] });
    },
    press: (key) =>
      send('input.performActions', {
        context,
        actions: [
          {
            type: 'key',
            id: 'keys',
            actions: ['keyDown', 'keyUp'].map((type) => ({ type, value: KEYS[key] ?? key })),
          },
        ],
      }),
    async close() {
      socket.close();
      program.kill();
      await new Promise((done) => program.on('exit', done));
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
