import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Helper, startHelper } from './helper.ts';

/** Where the programs of `tests/serial/native` were built; `scripts/serial-rig.mjs` tells. */
const programs = process.env['FRAMEWRIGHT_SERIAL'];
if (programs === undefined) throw new Error('These tests run by: npm run serial');
const cableProgram = join(programs, 'cable');
const peerProgram = join(programs, 'peer');

export interface CableOptions {
  /** The device name of the page's end; the chooser lists ports by it. */
  readonly name?: string;
  /** The page hears its own bytes, as on some RS-485 adapters. */
  readonly echo?: boolean | undefined;
  /** Characters take the time they have at the page's speed and format. */
  readonly pace?: boolean | undefined;
  /** What comes for the page comes in lumps so many milliseconds apart, as from a USB adapter. */
  readonly lump?: number | undefined;
}

/** A cable: the browser opens `port`, the device opens `device`. */
export interface Cable {
  readonly port: string;
  readonly device: string;
  /** The settings of the page's end, such as `9600 even 1 none`; `undefined` before it was first opened. */
  settings(): string | undefined;
  /** Pulls the cable out. */
  cut(): Promise<void>;
}

export async function joinCable({ name = 'ttyUSB0', echo, pace, lump }: CableOptions = {}): Promise<Cable> {
  const folder = mkdtempSync(join(tmpdir(), 'cable-'));
  const port = join(folder, name);
  const device = join(folder, 'device');
  const options = [...(echo ? ['echo'] : []), ...(pace ? ['pace'] : []), ...(lump ? [`lump=${lump}`] : [])];
  let settings: string | undefined;
  const program = await startHelper(cableProgram, ['join', port, device, ...options], (line) => {
    settings = line;
  });
  return {
    port,
    device,
    settings: () => settings,
    async cut() {
      await program.stop();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

/** What libmodbus, as a client at the device's end, reads of holding registers, or what it says went wrong. */
export const readAsClient = (tty: string, unit: number, address: number, quantity: number): string =>
  spawnSync(peerProgram, ['read', tty, `${unit}`, `${address}`, `${quantity}`], { encoding: 'utf8' }).stdout.trim();

/** A server by libmodbus: what it holds stands in `tests/serial/native/peer.c`. */
export const serve = (tty: string, unit = 1): Promise<Helper> => startHelper(peerProgram, ['serve', tty, String(unit)]);

/** An adapter as the system sees it. */
export interface Adapter {
  readonly name: string;
  readonly tty: string;
  readonly vendorId?: number;
  readonly productId?: number;
  readonly product?: string;
  /** The serial number; without one, a grant is gone when the adapter is pulled out. */
  readonly serial?: string;
}

/** Plugs an adapter in. The browser hears of it only behind the page's first use of `navigator.serial`. */
export const plug = (adapter: Adapter): void => announce('add', adapter);

export const unplug = (adapter: Adapter): void => announce('remove', adapter);

let sequence = 1;

function announce(action: 'add' | 'remove', { name, tty, vendorId, productId, product, serial }: Adapter): void {
  const hex = (id: number) => id.toString(16).padStart(4, '0');
  const [major, minor] = serialNumbers();
  const event: Record<string, string | number | undefined> = {
    ACTION: action,
    SUBSYSTEM: 'tty',
    SEQNUM: sequence++,
    DEVPATH: `/devices/cable/${name}/tty/${name}`,
    DEVNAME: tty,
    MAJOR: major,
    MINOR: minor,
    ID_BUS: vendorId === undefined ? undefined : 'usb',
    ID_VENDOR_ID: vendorId === undefined ? undefined : hex(vendorId),
    ID_MODEL_ID: productId === undefined ? undefined : hex(productId),
    ID_MODEL_ENC: product?.replaceAll(' ', '\\x20'),
    ID_SERIAL_SHORT: serial,
  };
  const pairs = Object.entries(event).flatMap(([key, value]) => (value === undefined ? [] : [`${key}=${value}`]));
  execFileSync(cableProgram, ['uevent', ...pairs]);
}

/** Major and minor number of a device that the kernel calls serial. */
function serialNumbers(): readonly [string, string] {
  for (const line of readFileSync('/proc/tty/drivers', 'utf8').split('\n')) {
    const [, , major, minors, type] = line.trim().split(/\s+/);
    if (type === 'serial' && major && minors) return [major, minors.split('-')[0] as string];
  }
  throw new Error('no driver of type serial in /proc/tty/drivers');
}
