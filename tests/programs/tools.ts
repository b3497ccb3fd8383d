import { spawn } from 'node:child_process';
import { createHash, type Hash } from 'node:crypto';
import {
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  realpathSync,
  renameSync,
  rmSync,
  statSync,
  utimesSync,
  writeFileSync,
} from 'node:fs';
import { delimiter, join } from 'node:path';
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

/** The command that is said to compile or check programs of a target: the tests run that one. */
export function strictTool(target: string): readonly [command: string, ...flags: string[]] {
  const [command, ...flags] = targetProof(target)?.command?.split(' ') ?? [];
  if (command === undefined) throw new RangeError(`no command for ${target}`);
  return [command === 'mypy' ? python(command) : command, ...flags];
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

/** What a tool makes of its sources is kept so long, in days. */
const KEPT = 7;
const kept = join(cache, 'kept');

/** A compiler or checker, and all that decides what it says and makes. */
interface Tool {
  /** Files and folders that it reads, packages with a version in their path aside. */
  readonly sources: readonly string[];
  /** The file or folder that it makes, if any. */
  readonly output?: string | undefined;
  readonly cwd?: string;
  readonly env?: Readonly<Record<string, string>>;
}

/**
 * Runs a tool on sources; if it went well before, with the same command and sources to the letter, takes what it said and made
 * then.
 */
export async function runTool(command: string, args: readonly string[], tool: Tool): Promise<Ran> {
  const { sources, output } = tool;
  const key = createHash('sha256').update(JSON.stringify([command, args, tool]));
  const path = [command, ...(process.env['PATH'] ?? '').split(delimiter).map((folder) => join(folder, command))].find(
    existsSync,
  );
  // Another version of the tool.
  if (path !== undefined) key.update(`${realpathSync(path)} ${statSync(path).mtimeMs} ${statSync(path).size}`);
  for (const source of sources) addTo(key, source);
  const folder = join(kept, key.digest('hex'));
  const said = join(folder, 'said.json');
  const made = join(folder, 'made');
  if (existsSync(said)) {
    if (output !== undefined) cpSync(made, output, { recursive: true });
    utimesSync(folder, new Date(), new Date());
    return JSON.parse(readFileSync(said, 'utf8')) as Ran;
  }
  const ran = await run(command, args, tool);
  if (ran.code !== 0) return ran;
  mkdirSync(folder, { recursive: true });
  if (output !== undefined) cpSync(output, made, { recursive: true });
  // Last, so that nothing is taken that is not there yet.
  writeFileSync(`${said}.new`, JSON.stringify(ran));
  renameSync(`${said}.new`, said);
  for (const name of readdirSync(kept))
    if (Date.now() - (statSync(join(kept, name), { throwIfNoEntry: false })?.mtimeMs ?? 0) > KEPT * 86_400_000)
      rmSync(join(kept, name), { recursive: true, force: true });
  return ran;
}

function addTo(key: Hash, path: string): void {
  if (statSync(path).isDirectory()) for (const name of readdirSync(path).sort()) addTo(key, join(path, name));
  else key.update(JSON.stringify([path, readFileSync(path, 'latin1')]));
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
