import { spawn } from 'node:child_process';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'vite';
import { expect, inject, test } from 'vitest';
import { type TargetProof, targetProof } from '../../src/codegen/index.ts';

declare module 'vitest' {
  interface ProvidedContext {
    /** What the tests need and is not there, by its name in `scripts/programs-tools.json`, and how to get it. */
    readonly missing: Readonly<Record<string, string>>;
  }
}

/** Where packages of other languages are, and the folders of programs. */
export const cache = join(import.meta.dirname, '../../.cache/programs');

/** Whether to test with many more requests. */
export const full = process.env['PROGRAMS_FULL'] === '1';

/** A command of the Python that has the packages, such as `mypy`. */
export const python = (command = 'python') => join(cache, 'venv/bin', command);

/**
 * Says `tests` if the commands and languages of `names` are there. Otherwise there is one test that says what is missing, and
 * fails on a server.
 */
export function withTools(names: readonly string[], tests: () => void): void {
  const missing = names.flatMap((name) => inject('missing')[name] ?? []);
  if (missing.length === 0) tests();
  else {
    test(`NOT RUN: ${missing.join('; ')}`, () => {
      expect(process.env['CI'] ?? '').toMatch(/^(0|false)?$/);
    });
  }
}

/** Holds what is said of a target true: how its programs were proved, and of how many requests. */
export function expectProved(target: string, ran: TargetProof): void {
  if (!full) expect(targetProof(target)).toEqual(ran);
}

/** An empty folder for the programs of one test file. */
export function emptyFolder(name: string): string {
  const folder = join(cache, 'run', name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  return folder;
}

export interface Ran {
  readonly code: number;
  readonly out: string;
  readonly err: string;
}

/** Runs a program to its end. */
export function run(
  command: string,
  args: readonly string[],
  options: { readonly cwd?: string; readonly input?: string; readonly env?: Readonly<Record<string, string>> } = {},
): Promise<Ran> {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { cwd: options.cwd, env: { ...process.env, ...options.env } });
    let out = '';
    let err = '';
    child.stdout.setEncoding('utf8').on('data', (text: string) => {
      out += text;
    });
    child.stderr.setEncoding('utf8').on('data', (text: string) => {
      err += text;
    });
    child.on('error', reject);
    child.on('close', (code) => resolve({ code: code ?? 1, out, err }));
    child.stdin.on('error', () => {});
    child.stdin.end(options.input ?? '');
  });
}

let built: Promise<void> | undefined;

/** Builds our own library to where the programs in `.cache/programs/run` find it by its name. */
export function buildLibrary(): Promise<void> {
  built ??= (async () => {
    const folder = join(cache, 'run/node_modules/framewright');
    mkdirSync(folder, { recursive: true });
    // Otherwise the name would mean the project around.
    writeFileSync(join(cache, 'run/package.json'), JSON.stringify({ private: true }));
    writeFileSync(
      join(folder, 'package.json'),
      JSON.stringify({ name: 'framewright', type: 'module', exports: './framewright.js' }),
    );
    const config = join(cache, '../../vite.lib.config.ts');
    await build({ configFile: config, logLevel: 'error', build: { outDir: folder, emptyOutDir: false } });
  })();
  return built;
}
