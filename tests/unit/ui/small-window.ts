import { options } from 'preact';
import { vi } from 'vitest';
import { SmallDocument } from './small-document.ts';

/** Lets what is to be loaded and drawn come; however long the parts take. */
export async function settle(): Promise<void> {
  for (let turn = 0; turn < 50; turn++) {
    await vi.dynamicImportSettled();
    await new Promise((done) => setTimeout(done, 4));
  }
}

/** A window that is just enough for the page to be drawn in, at an address; `more` are further globals. Answers its document. */
export function stubWindow(hash: string, more: Readonly<Record<string, unknown>> = {}): SmallDocument {
  const document = new SmallDocument();
  const globals = {
    document,
    location: { hash, pathname: '/', search: '' },
    history: { replaceState: () => undefined, pushState: () => undefined },
    addEventListener: () => undefined,
    requestAnimationFrame: setTimeout,
    cancelAnimationFrame: clearTimeout,
    localStorage: { getItem: () => null, setItem: () => undefined },
    sessionStorage: { getItem: () => null, setItem: () => undefined, removeItem: () => undefined },
    ...more,
  };
  for (const [name, value] of Object.entries(globals)) vi.stubGlobal(name, value);
  return document;
}

/** The names of the components that are drawn from now on. */
export class Drawn {
  names: string[] = [];
  readonly #before: ((node: unknown) => void) | undefined = Reflect.get(options, '__r');

  constructor() {
    Reflect.set(options, '__r', (node: { readonly type: { readonly name: string } }) => {
      this.#before?.(node);
      this.names.push(node.type.name);
    });
  }

  stop(): void {
    Reflect.set(options, '__r', this.#before);
  }
}

/** How often components of a name were drawn. */
export const times = (names: readonly string[], name: string): number => names.filter((each) => each === name).length;
