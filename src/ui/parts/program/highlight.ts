import type { Emitter, LanguageFn } from 'highlight.js';
import hljs from 'highlight.js/lib/core';

/** A piece of a line, and what it is: a scope of highlight.js such as `keyword`, or blank. */
export interface Token {
  readonly text: string;
  readonly scope: string;
}

/** The tokens of each line. */
export type TokenLines = readonly (readonly Token[])[];

/** Makes tokens of a text. */
export type Highlight = (text: string) => TokenLines;

/**
 * Takes what highlight.js finds as tokens by line, not as HTML: the page's policy lets no text become elements. This is the
 * interface that the library offers for that purpose, though it calls it its own.
 */
class TokenEmitter implements Emitter {
  readonly lines: Token[][] = [[]];
  readonly #scopes: string[] = [];

  addText(text: string): void {
    const scope = this.#scopes.findLast((name) => name !== '') ?? '';
    for (const [index, part] of text.split('\n').entries()) {
      if (index > 0) this.lines.push([]);
      if (part !== '') this.lines.at(-1)?.push({ text: part, scope });
    }
  }

  startScope(name: string): void {
    // `title.function` is a title; what a language nests in another is named with a colon.
    this.#scopes.push(/^[a-z_]*(?![a-z_:])/.exec(name)?.[0] ?? '');
  }

  endScope(): void {
    this.#scopes.pop();
  }

  openNode(name: string): void {
    this.startScope(name);
  }

  closeNode(): void {
    this.endScope();
  }

  __addSublanguage({ lines }: TokenEmitter): void {
    for (const [index, tokens] of lines.entries()) {
      if (index > 0) this.lines.push([]);
      this.lines.at(-1)?.push(...tokens);
    }
  }

  finalize(): void {}

  toHTML(): string {
    return '';
  }
}

hljs.configure({ __emitter: TokenEmitter });

/** The lines of a text of which nothing is known. */
export const plainLines: Highlight = (text) =>
  text.split('\n').map((line) => (line === '' ? [] : [{ text: line, scope: '' }]));

/** What makes tokens of texts in a language. Where it loses a character of the text, the text is plain. */
export function highlightIn(name: string, language: LanguageFn): Highlight {
  hljs.registerLanguage(name, language);
  return (text) => {
    const { _emitter: emitter } = hljs.highlight(text, { language: name, ignoreIllegals: true });
    const lines = emitter instanceof TokenEmitter ? emitter.lines : [];
    const kept = lines.map((tokens) => tokens.map((token) => token.text).join('')).join('\n');
    return kept === text ? lines : plainLines(text);
  };
}
