import type { LanguageFn } from 'highlight.js';
import structuredText from 'highlightjs-structured-text';
import type { Code } from '../slot.tsx';
import { type Highlight, highlightIn, plainLines } from './highlight.ts';

const language = (
  name: string,
  load: () => Promise<{ readonly default: LanguageFn }>,
): readonly [string, Code<Highlight>] => [
  name,
  { words: [], load: async () => highlightIn(name, (await load()).default) },
];

/** Structured Text with literals such as `WORD#16#A001` whole: the package has digits only behind the last `#`. */
const withBasedNumbers =
  (of: LanguageFn): LanguageFn =>
  (hljs) => {
    const known = of(hljs);
    return { ...known, contains: [{ scope: 'number', begin: /\b(?:[A-Z_]+#)?\d+#[\dA-F_]+/ }, ...known.contains] };
  };

/** Languages of files that are not in the language of their target. */
const byEnding: ReadonlyMap<string, string> = new Map([
  ['xml', 'xml'],
  ['svg', 'xml'],
  ['st', 'iecst'],
]);

const languages: ReadonlyMap<string, Code<Highlight>> = new Map([
  language('iecst', async () => ({ default: withBasedNumbers(structuredText) })),
  language('c', () => import('highlight.js/lib/languages/c')),
  language('arduino', () => import('highlight.js/lib/languages/arduino')),
  language('csharp', () => import('highlight.js/lib/languages/csharp')),
  language('java', () => import('highlight.js/lib/languages/java')),
  language('go', () => import('highlight.js/lib/languages/go')),
  language('rust', () => import('highlight.js/lib/languages/rust')),
  language('python', () => import('highlight.js/lib/languages/python')),
  language('javascript', () => import('highlight.js/lib/languages/javascript')),
  language('bash', () => import('highlight.js/lib/languages/bash')),
  language('powershell', () => import('highlight.js/lib/languages/powershell')),
  language('xml', () => import('highlight.js/lib/languages/xml')),
]);

const plain: Code<Highlight> = { words: [], load: async () => plainLines };

/** What brings the highlighting of a language of a target, or of a file by its ending. */
export function highlighting(name: string, file: string): Code<Highlight> {
  const [, ending = ''] = /\.([a-z]+)$/.exec(file) ?? [];
  return languages.get(byEnding.get(ending) ?? name) ?? plain;
}
