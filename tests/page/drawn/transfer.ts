/** What is dragged, and the events that tell of it: the document in this process takes no file of Node, and drags nothing. */
export function addTransfers(): void {
  const event = class extends MouseEvent {
    readonly dataTransfer: unknown;
    constructor(type: string, init: DragEventInit = {}) {
      super(type, init);
      this.dataTransfer = init.dataTransfer ?? null;
    }
  };
  for (const [name, value] of Object.entries({ DataTransfer: DrawnTransfer, DragEvent: event })) {
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
