import { spawn } from 'node:child_process';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('..', import.meta.url));

/**
 * Runs a program from the root of the project, its output shown as it comes, or told to `tell`.
 * @param {string} command
 * @param {string[]} args
 * @param {{ env?: Record<string, string>, shell?: boolean, timeout?: number, tell?: (text: string) => void }} [options]
 *   timeout in milliseconds
 * @returns {Promise<number>} the exit code; 1 when it could not be started or was stopped
 */
export function run(command, args, { env = {}, shell = false, timeout = 0, tell } = {}) {
  return new Promise((resolve) => {
    const child = spawn(command, args, {
      cwd: root,
      stdio: tell ? ['ignore', 'pipe', 'pipe'] : 'inherit',
      shell,
      timeout,
      // A pipe is no terminal, and yet what goes through it may be shown on one.
      env: { ...process.env, ...(tell && process.stdout.isTTY && { FORCE_COLOR: '1' }), ...env },
    });
    for (const stream of [child.stdout, child.stderr]) stream?.setEncoding('utf8').on('data', (text) => tell?.(text));
    child.on('error', (error) => {
      (tell ?? console.error)(`${command}: ${error.message}`);
      resolve(1);
    });
    child.on('close', (code) => resolve(code ?? 1));
  });
}

/**
 * Runs npm, the same one that started this script if there was one.
 * @param {string[]} args
 * @param {Parameters<typeof run>[2]} [options]
 */
export function runNpm(args, options) {
  const npm = process.env.npm_execpath;
  if (npm?.endsWith('npm-cli.js')) return run(process.execPath, [npm, ...args], options);
  return run('npm', args, { ...options, shell: process.platform === 'win32' });
}

/**
 * Runs a script of package.json.
 * @param {string} name
 * @param {string[]} [args]
 * @param {Parameters<typeof run>[2]} [options]
 */
export function runScript(name, args = [], options = {}) {
  return runNpm(['run', '--silent', name, '--', ...args], options);
}
