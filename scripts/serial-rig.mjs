// What the tests against the real Web Serial API need besides a browser, and how to run something where it can plug
// in serial ports of its own: in namespaces, so that nothing of the machine is touched.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { installDebianPackages } from './debian.mjs';
import { root } from './run.mjs';

const sources = join(root, 'tests', 'serial', 'native');
const built = join(root, '.cache', 'serial');
const packages = ['gcc', 'libc6-dev', 'pkg-config', 'libmodbus-dev', 'iproute2', 'util-linux'];

/** What is said where these tests cannot run. */
export const howToGetASerialRig = `They need Linux, the right to make namespaces (root, or user namespaces), and from Debian or Ubuntu:
  apt-get install ${packages.join(' ')}`;

/** Tells what runs in the namespaces where the programs at the other end of the cable are. */
export const serialEnvironment = { FRAMEWRIGHT_SERIAL: built };

/**
 * Gets ready what can be got ready: packages where they may be installed, and the programs, built when their sources
 * are newer.
 * @returns {Promise<string | undefined>} why it cannot be done here; `undefined` when all is ready
 */
export async function prepareSerialRig() {
  if (process.platform !== 'linux') return 'Serial ports can be made up on Linux only.';
  if (!hasTools()) await installDebianPackages(packages);
  if (!hasTools()) return 'A C compiler, pkg-config, libmodbus or the program ip is missing.';
  const [unshare, args] = inNamespaces(['true']);
  if (spawnSync(unshare, args, { stdio: 'ignore' }).status !== 0) return 'Namespaces may not be made here.';
  mkdirSync(built, { recursive: true });
  const modbus = spawnSync('pkg-config', ['--cflags', '--libs', 'libmodbus'], { encoding: 'utf8' })
    .stdout.trim()
    .split(/\s+/);
  const failed =
    !compile('cable', []) || !compile('peer', modbus) || !compile('modem-lines', ['-shared', '-fPIC', '-ldl']);
  return failed ? 'The programs of tests/serial/native could not be compiled.' : undefined;
}

/**
 * A command that runs another where serial ports can be plugged in: with a network of its own, so that made-up events
 * of udev stay inside and no port of TCP is taken, and with mounts of its own. Call `prepareSerialRig` first.
 * @param {readonly string[]} command
 * @returns {[string, string[]]} the program and its arguments
 */
export function inNamespaces(command) {
  const map = process.getuid?.() === 0 ? [] : ['--map-root-user'];
  return ['unshare', [...map, '--net', '--mount', 'sh', '-euc', setUp, 'sh', ...command]];
}

const setUp = `
  ip link set lo up
  # libudev hears events only where udevd runs or /dev is a devtmpfs, and a container has neither.
  [ -e /run/udev/control ] || { mount -t tmpfs tmpfs /run; mkdir /run/udev; : >/run/udev/control; }
  # The machine's own ports are hidden: there are only those that are plugged in.
  mount -t tmpfs tmpfs /sys/class/tty
  # Chromium takes only ports whose numbers belong to a driver of type "serial".
  grep -q " serial$" /proc/tty/drivers || {
    drivers=$(mktemp); cat /proc/tty/drivers >"$drivers"
    echo "serial /dev/ttyS 4 64-95 serial" >>"$drivers"
    mount --bind "$drivers" /proc/tty/drivers; rm "$drivers"; }
  exec "$@"`;

function hasTools() {
  const found = (/** @type {string} */ program) => spawnSync('sh', ['-c', `command -v ${program}`]).status === 0;
  return (
    ['cc', 'pkg-config', 'ip', 'unshare'].every(found) &&
    spawnSync('pkg-config', ['--exists', 'libmodbus']).status === 0
  );
}

/**
 * @param {string} name
 * @param {readonly string[]} flags
 */
function compile(name, flags) {
  const source = join(sources, `${name}.c`);
  const program = join(built, name);
  if (existsSync(program) && statSync(program).mtimeMs > statSync(source).mtimeMs) return true;
  const args = ['-O2', '-Wall', '-Wextra', '-Werror', '-o', program, source, ...flags];
  return spawnSync('cc', args, { stdio: 'inherit' }).status === 0;
}
