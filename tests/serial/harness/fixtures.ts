import { defaultRules } from '#known';
import { test as base } from '../../browser/page.ts';
import { type Adapter, type Cable, type CableOptions, joinCable, plug, serve, unplug } from './cable.ts';
import type { Helper } from './helper.ts';

export { expect } from '../../browser/page.ts';

/** An adapter that is plugged in, with its cable. */
export interface PluggedAdapter {
  readonly device: Omit<Adapter, 'tty'>;
  cable: Cable;
  /** Pulls the adapter out of the computer, as a hand does. */
  pullOut(): Promise<void>;
  /** Plugs it in again, with a server at the other end. */
  plugIn(): Promise<void>;
}

interface AdapterOptions extends CableOptions, Partial<Omit<Adapter, 'tty'>> {
  /** The unit that answers; `null` for a line without a server. */
  readonly unit?: number | null;
}

export const FTDI = { vendorId: 0x0403, productId: 0x6001, product: 'FT232R USB UART', serial: 'A50285BI' };
/** Adapters of this kind have no serial number. */
export const CH340 = { vendorId: 0x1a86, productId: 0x7523, product: 'USB Serial' };

let count = 0;

interface Fixtures {
  /** How long the page waits for a reply at first, in milliseconds: longer than any reply takes on a machine with other work to do. */
  readonly replyTimeout: number;
  readonly plugAdapter: (options?: AdapterOptions) => Promise<PluggedAdapter>;
}

/** Playwright's test with adapters: each has a name of its own, and is pulled out when the test ends. */
export const test = base.extend<Fixtures>({
  replyTimeout: [20_000, { option: true }],
  plugAdapter: async ({ page, replyTimeout }, use) => {
    await page.addInitScript(
      ([key, rules]) => {
        if (localStorage.getItem(key) === null) localStorage.setItem(key, rules);
      },
      ['framewright.bus-rules', JSON.stringify({ ...defaultRules, timeout: replyTimeout })] as const,
    );
    // An adapter is heard of only behind a page's first use of the API.
    await page.goto('/');
    await page.evaluate(() => navigator.serial.getPorts());
    const plugged: PluggedAdapter[] = [];
    await use(async ({ unit = 1, echo, pace, lump, ...rest } = {}) => {
      // The chooser lists ports in the order of their names, as text.
      const name = `ttyUSB${String(count++).padStart(3, '0')}`;
      const kind = rest.vendorId === undefined ? FTDI : {};
      const one = await plugIn({ echo, pace, lump }, unit, { ...kind, ...rest, name });
      plugged.push(one);
      return one;
    });
    // What pulls an adapter out of a page that uses it is a test; here the browser has done with it before.
    await page.close();
    for (const one of plugged) await one.pullOut();
  },
});

async function plugIn(
  options: CableOptions,
  unit: number | null,
  device: Omit<Adapter, 'tty'>,
): Promise<PluggedAdapter> {
  let server: Helper | undefined;
  const connect = async () => {
    const cable = await joinCable({ ...options, name: device.name });
    if (unit !== null) server = await serve(cable.device, unit);
    plug({ ...device, tty: cable.port });
    return cable;
  };
  let isIn = true;
  const one = {
    device,
    cable: await connect(),
    async pullOut() {
      if (!isIn) return;
      isIn = false;
      await one.cable.cut();
      await server?.stop();
      unplug({ ...device, tty: one.cable.port });
    },
    async plugIn() {
      one.cable = await connect();
      isIn = true;
    },
  };
  return one;
}
