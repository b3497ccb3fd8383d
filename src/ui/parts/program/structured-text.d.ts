/** The package has no types. */
declare module 'highlightjs-structured-text' {
  import type { LanguageFn } from 'highlight.js';

  const structuredText: LanguageFn;
  // biome-ignore lint/style/noDefaultExport: what the package exports.
  export default structuredText;
}
