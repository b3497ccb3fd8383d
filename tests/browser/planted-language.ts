import { execFile } from 'node:child_process';
import { cp, mkdir, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { promisify } from 'node:util';
import { preview } from 'vite';

const root = resolve(import.meta.dirname, '../..');

/** English with every sentence between ⟦ and ⟧, also those that functions make. */
const PLANTED = `
import { english } from '../en/index.ts';

function marked(said: unknown): unknown {
  if (typeof said === 'string') return /\\p{L}/u.test(said) ? '⟦' + said + '⟧' : said;
  if (typeof said === 'function') return (...args: unknown[]) => marked(said(...args));
  if (Array.isArray(said)) return said.map(marked);
  if (said instanceof Map) return new Map([...said].map(([key, value]) => [key, marked(value)]));
  if (typeof said !== 'object' || said === null) return said;
  const all = Object.create(Object.getPrototypeOf(said));
  for (const [key, value] of Object.entries(said)) all[key] = marked(value);
  return all;
}

export const planted = Object.fromEntries(
  Object.entries(english).map(([subject, load]) => [subject, async () => marked(await load())]),
) as unknown as typeof english;
`;

const copied = [
  'src',
  'public',
  'scripts',
  'LICENSE',
  'index.html',
  'package.json',
  'vite.config.ts',
  'tsconfig.base.json',
  'tsconfig.layer.json',
];

/** The page with one more language, `qps`: a folder and a line in the list of languages. */
export async function servePlanted(): Promise<{ readonly address: string; stop(): Promise<void> }> {
  const folder = await mkdtemp(join(tmpdir(), 'framewright-language-'));
  await Promise.all(copied.map((name) => cp(join(root, name), join(folder, name), { recursive: true })));
  await symlink(join(root, 'node_modules'), join(folder, 'node_modules'), 'junction');
  await mkdir(join(folder, 'src/words/qps'));
  await writeFile(join(folder, 'src/words/qps/index.ts'), PLANTED);
  const list = join(folder, 'src/words/languages.ts');
  const text = await readFile(list, 'utf8');
  const more = text.replace('languages = { en: english }', 'languages = { en: english, qps: planted }');
  if (more === text) throw new Error('The list of languages is not where it was.');
  await writeFile(list, `import { planted } from './qps/index.ts';\n${more}`);
  await promisify(execFile)(process.execPath, [join(root, 'node_modules/vite/bin/vite.js'), 'build'], { cwd: folder });
  const server = await preview({ root: folder, logLevel: 'silent', preview: { host: '127.0.0.1', port: 0 } });
  return {
    address: server.resolvedUrls?.local[0] ?? '',
    async stop() {
      await server.close();
      await rm(folder, { recursive: true });
    },
  };
}
