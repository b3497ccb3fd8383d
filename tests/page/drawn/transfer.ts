import type { Window } from 'happy-dom';

/**
 * What is dragged, the events that tell of it, and what is copied: the document in this process takes no file of Node, and
 * drags nothing.
 */
export function addTransfers(window: Window): void {
  const event = class extends MouseEvent {
    readonly dataTransfer: unknown;
    constructor(type: string, init: DragEventInit = {}) {
      super(type, init);
      this.dataTransfer = init.dataTransfer ?? null;
    }
  };
  const bytesOf = async (given: string | Blob | PromiseLike<string | Blob>) => {
    const content = await given;
    return content instanceof Blob ? new Uint8Array(await content.arrayBuffer()) : content;
  };
  const item = class extends (window.ClipboardItem as unknown as typeof ClipboardItem) {
    constructor(data: Record<string, Parameters<typeof bytesOf>[0]>) {
      super(Object.fromEntries(Object.entries(data).map(([type, given]) => [type, bytesOf(given) as never])));
    }
  };
  const all = { DataTransfer: DrawnTransfer, DragEvent: event, ClipboardItem: item };
  for (const [name, value] of Object.entries(all)) {
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  }
}

class DrawnTransfer {
  readonly #texts = new Map<string, string>();
  readonly #files: File[] = [];

  readonly items = {
    add: (given: File | string, type = '') => {
      if (typeof given === 'string') this.setData(type, given);
      else this.#files.push(given);
    },
  };

  get files(): readonly File[] {
    return this.#files;
  }

  get types(): readonly string[] {
    return [...this.#texts.keys(), ...(this.#files.length > 0 ? ['Files'] : [])];
  }

  setData(type: string, text: string): void {
    this.#texts.set(nameOf(type), text);
  }

  getData(type: string): string {
    return this.#texts.get(nameOf(type)) ?? '';
  }
}

const nameOf = (type: string) => (type === 'text' ? 'text/plain' : type.toLowerCase());
