import { readFileSync } from 'node:fs';

/**
 * The address of the script that the build made of a module, as `src/words/en/checksum.ts`, or of what several modules share, by
 * the name that the build gives it.
 */
export function builtFile(module: string): RegExp {
  const manifest: Readonly<Record<string, { readonly file: string; readonly name?: string }>> = JSON.parse(
    readFileSync(new URL('../../dist/manifest.json', import.meta.url), 'utf8'),
  );
  const built = manifest[module] ?? Object.values(manifest).find(({ name }) => name === module);
  if (built === undefined) throw new Error(`The build made no file of ${module}.`);
  return new RegExp(`/${built.file.replaceAll('.', '\\.')}$`);
}
