import type { LanguageFn } from 'highlight.js';
import type { Code } from '../slot.tsx';
import { type Highlight, highlightIn, plainLines } from './highlight.ts';

const language = (
  name: string,
  load: () => Promise<{ readonly default: LanguageFn }>,
): readonly [string, Code<Highlight>] => [
  name,
  { words: [], load: async () => highlightIn(name, (await load()).default) },
];

const languages: ReadonlyMap<string, Code<Highlight>> = new Map([
  language('iecst', () => import('highlightjs-structured-text')),
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
  const markup = /\.(xml|svg)$/.test(file);
  return languages.get(markup ? 'xml' : name) ?? plain;
}
