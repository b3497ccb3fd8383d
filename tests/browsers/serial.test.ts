import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, test } from 'vitest';
// @ts-expect-error: the script has no types of its own.
import { serveBuiltPage } from '../../scripts/static-server.mjs';
import { joinCable, serve } from '../serial/harness/cable.ts';
import { Driver } from './driver.ts';
import { openFirefox } from './firefox.ts';

const { FRAMEWRIGHT_FIREFOX: firefox = '', FRAMEWRIGHT_SERIAL: programs = '' } = process.env;

/** What Firefox calls the port. */
const PRODUCT = 'FT232R_USB_UART';

/**
 * Makes a pseudo-terminal an adapter for Firefox, in this run's own mounts: it looks into the system's list of terminals and
 * into /dev for each list that it shows, and opens all that it finds there.
 */
function plug(port: string): void {
  execFileSync('sh', ['-euc', setUp, 'sh', port, PRODUCT]);
}

const setUp = `
  own=$(mktemp -d); mount -t tmpfs tmpfs "$own"
  for name in null zero full random urandom tty ptmx; do : >"$own/$name"; mount --bind "/dev/$name" "$own/$name"; done
  for name in pts shm; do mkdir "$own/$name"; mount --bind "/dev/$name" "$own/$name"; done
  ln -s /proc/self/fd "$own/fd"; ln -s "$1" "$own/ttyUSB0"
  mount --rbind "$own" /dev
  adapter=/sys/class/tty/ttyUSB0
  mkdir -p "$adapter" /run/udev/data
  printf 'MAJOR=4\\nMINOR=64\\nDEVNAME=ttyUSB0\\n' >"$adapter/uevent"
  ln -s /sys/class/tty "$adapter/subsystem"
  printf 'E:ID_BUS=usb\\nE:ID_VENDOR_ID=0403\\nE:ID_MODEL_ID=6001\\nE:ID_MODEL=%s\\n' "$2" >/run/udev/data/c4:64`;

test('a port is chosen in Firefox, and libmodbus answers', async () => {
  const { address, close } = await serveBuiltPage();
  const cable = await joinCable();
  const server = await serve(cable.device);
  plug(cable.port);
  const browser = await openFirefox(firefox, {
    LD_PRELOAD: join(programs, 'modem-lines'),
    // Its list of terminals is not the kernel's here.
    SYSTEMD_DEVICE_VERIFY_SYSFS: '0',
  });
  try {
    const page = new Driver(await browser.open(), address);
    await page.open('#rtu/request?unitId=1&functionCode=3&startAddress=10&quantity=2');
    await page.click('link', 'Bus');
    await page.click('button', 'Connect…');
    await browser.allowPort(PRODUCT);
    await page.sees('region', 'Connection', /Connected to FTDI FT232R, 19200 baud, 8E1/);
    expect(cable.settings()).toBe('19200 even 1 none');
    await page.click('button', 'Send');
    // 1010 and 1011
    await page.sees('region', 'Last reply', /01 03 04 03 F2 03 F3 1B 31/);
    await page.click('tab', 'Poll');
    await page.fill('Interval (ms)', '20');
    await page.click('button', 'Start');
    await page.sees('region', /^Values: /, /\d\d rounds/);
    await page.click('button', 'Stop');
    await page.click('button', 'Disconnect');
    await page.sees('region', 'Connection', /Not connected\./);
    expect(await page.complaints()).toEqual([]);
  } finally {
    await browser.close();
    await server.stop();
    await cable.cut();
    close();
  }
});
