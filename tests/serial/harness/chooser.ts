import { once } from 'node:events';
import WebSocket from 'ws';
import { pause, until } from './helper.ts';

/** Where Chromium's UI DevTools listen; the network is this run's own. */
export const UI_PORT = 9223;

/** What makes Chromium's own windows readable and clickable in headless mode. */
export const chooserArgs = [
  `--enable-ui-devtools=${UI_PORT}`,
  '--enable-features=ui-debug-tools-enable-synthetic-events',
];

interface UiNode {
  readonly nodeId: number;
  readonly nodeName: string;
  readonly attributes?: readonly string[];
  readonly children?: readonly UiNode[];
}

/** The browser's own chooser of ports, read and clicked as a user does. */
export interface Chooser {
  rows(): Promise<number>;
  texts(): Promise<string[]>;
  pick(row?: number): Promise<void>;
  cancel(): Promise<void>;
}

/** Waits for the chooser to open. */
export async function openedChooser(): Promise<Chooser> {
  const ui = await connect();
  const bubble = async () => {
    const { root } = await ui.ask<{ root: UiNode }>('DOM.getDocument');
    return named(root, 'ChooserBubbleUiViewDelegate').find(({ nodeName }) => nodeName === 'Window');
  };
  const properties = async ({ nodeId }: UiNode): Promise<Record<string, string>> => {
    const styles = await ui.ask<{
      matchedCSSRules: { rule: { style: { cssProperties: { name: string; value: string }[] } } }[];
    }>('CSS.getMatchedStylesForNode', { nodeId });
    return Object.fromEntries(
      styles.matchedCSSRules.flatMap(({ rule }) => rule.style.cssProperties.map(({ name, value }) => [name, value])),
    );
  };
  const click = async ({ nodeId }: UiNode, x: number, y: number) => {
    for (const type of ['mouseEntered', 'mousePressed', 'mouseReleased']) {
      await ui.ask('DOM.dispatchMouseEvent', {
        nodeId,
        event: { type, x, y, button: 'left', wheelDirection: 'none' },
      });
    }
  };

  await ui.ask('DOM.enable');
  await ui.ask('CSS.enable');
  const window = await until('the chooser', bubble);
  const [table] = named(window, 'TableView');
  if (table === undefined) throw new Error('the chooser has no table');
  const button = async (text: string): Promise<UiNode> => {
    for (const node of named(window, 'MdTextButton')) if ((await properties(node))['Text'] === text) return node;
    throw new Error(`the chooser has no button ${text}`);
  };
  const rows = async () => Number((await properties(table))['RowCount']);

  const press = async (text: string) => {
    const node = await button(text);
    await until(`the chooser to close on ${text}`, async () => {
      // A bubble ignores clicks in its first half second, and series of quick clicks.
      await pause(600);
      // The bubble may close under the click.
      await click(node, 10, 10).catch(() => {});
      await pause(100);
      return !(await bubble());
    });
    ui.close();
  };

  return {
    rows,
    texts: () => Promise.all(named(window, 'Label').map(async (label) => (await properties(label))['Text'] ?? '')),
    async pick(row = 0) {
      await until(`row ${row} in the chooser`, async () => (await rows()) > row);
      const height = Number((await properties(table))['RowHeight']);
      // A click on a list that is being filled may be lost.
      await until('the button Connect', async () => {
        await click(table, 30, row * height + 10);
        return (await properties(await button('Connect')))['Enabled'] === 'true';
      });
      await press('Connect');
    },
    cancel: () => press('Cancel'),
  };
}

const everything = (node: UiNode): UiNode[] => [node, ...(node.children ?? []).flatMap(everything)];
const named = (node: UiNode, name: string) => everything(node).filter(({ attributes }) => attributes?.includes(name));

interface Connection {
  ask<T>(method: string, params?: object): Promise<T>;
  close(): void;
}

async function connect(): Promise<Connection> {
  const socket = new WebSocket(`ws://127.0.0.1:${UI_PORT}/0`);
  await once(socket, 'open');
  const waiting = new Map<number, (answer: { error?: { message: string }; result: unknown }) => void>();
  socket.on('message', (message) => {
    const answer = JSON.parse(String(message));
    waiting.get(answer.id)?.(answer);
    waiting.delete(answer.id);
  });
  let last = 0;
  return {
    ask: <T>(method: string, params: object = {}) =>
      new Promise<T>((resolve, reject) => {
        last += 1;
        waiting.set(last, ({ error, result }) =>
          error ? reject(new Error(`${method}: ${error.message}`)) : resolve(result as T),
        );
        socket.send(JSON.stringify({ id: last, method, params }));
      }),
    close: () => socket.close(),
  };
}
