import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { policyOfFile } from '../content-security-policy.mjs';

/** @param {string} path from the root of the project; its lines end as those of an HTML document do once it is read */
const textOf = (path) =>
  readFileSync(fileURLToPath(new URL(`../../${path}`, import.meta.url)), 'utf8').replaceAll('\r\n', '\n');

/**
 * A source of a policy that allows exactly this text.
 * @param {string} text
 */
const hashOf = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/**
 * Writes `index.html` with all that it needs in it, as the only file of the build, named `fileName`. Its script is packed:
 * plain, the page and its workers weigh more than twice as much. Workers run the same script (`entry.js`), since it is the
 * only one there is.
 * @param {string} fileName
 * @returns {import('vite').Plugin}
 */
export function oneFile(fileName) {
  return {
    name: 'one-file',
    enforce: 'pre',
    resolveId(source) {
      return source.endsWith('/worker-script.ts')
        ? this.resolve('/src/ui/parts/workers/worker-script-in-one-file.ts')
        : undefined;
    },
    generateBundle: {
      order: 'post',
      handler(_, bundle) {
        const parts = Object.entries(bundle);
        const script = parts.flatMap(([, part]) => (part.type === 'chunk' ? part.code : []));
        const style = parts.flatMap(([name, part]) =>
          part.type === 'asset' && name.endsWith('.css') ? part.source : [],
        );
        if (script.length !== 1 || style.length !== 1) {
          throw new Error(`The one file is made of one script and one style, not of ${Object.keys(bundle)}.`);
        }
        for (const [name] of parts) delete bundle[name];
        this.emitFile({ type: 'asset', fileName, source: documentOf(String(script), String(style)) });
      },
    },
  };
}

/**
 * @param {string} script
 * @param {string} style
 */
function documentOf(script, style) {
  const theme = textOf('public/theme.js');
  const unpack = textOf('scripts/one-file/unpack.js');
  const inStyle = style.replaceAll('\r\n', '\n');
  if (/<\/(style|script)/i.test(inStyle + theme + unpack)) throw new Error('An inline text would end its own element.');
  const policy = policyOfFile([hashOf(theme), hashOf(unpack)], hashOf(inStyle));
  const icon = Buffer.from(textOf('public/favicon.svg')).toString('base64');
  const packed = gzipSync(script, { level: 9 }).toString('base64');
  const waiting =
    'Framewright is unpacking itself. If this sentence stays, this browser cannot run it: it is too old, or it forbids ' +
    'scripts in files. Open the file with a newer one.';
  /** @type {[RegExp, (found: string, first: string) => string][]} */
  const changes = [
    [
      /<meta charset="utf-8" \/>/,
      (meta) => `${meta}\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`,
    ],
    [/\.\/favicon\.svg/, () => `data:image/svg+xml;base64,${icon}`],
    [/<link [^>]*rel="manifest"[^>]*>/, () => ''],
    [/<script [^>]*theme\.js"><\/script>/, () => `<script>${theme}</script>`],
    [/<script type="module" [^>]*><\/script>/, () => `<style>${inStyle}</style>`],
    [/(<div id="app">\s*<p>)[^<]*/, (_, begin) => begin + waiting],
    [
      /\s*<\/body>/,
      (end) =>
        `\n    <script type="application/gzip;base64" id="packed">${packed}</script>\n    <script>${unpack}</script>${end}`,
    ],
  ];
  return changes.reduce((html, [place, text]) => {
    if (!place.test(html)) throw new Error(`index.html has no ${place}.`);
    return html.replace(place, text);
  }, textOf('index.html'));
}
