import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** A file that the page gave, as Playwright tells of it. */
export interface Download {
  suggestedFilename(): string;
  path(): Promise<string>;
}

/** What the page gives to be kept. */
export class Downloads {
  readonly #blobs = new Map<string, Blob>();
  readonly #waiting: ((download: Download) => void)[] = [];
  #folder: string | undefined;

  next(): Promise<Download> {
    return new Promise((resolve) => this.#waiting.push(resolve));
  }

  /** Has the page's addresses of blobs known here. */
  listen(): void {
    let last = 0;
    URL.createObjectURL = (blob: Blob) => {
      last += 1;
      const address = `blob:${last}`;
      this.#blobs.set(address, blob);
      return address;
    };
    URL.revokeObjectURL = () => undefined;
  }

  /** A link with a name for what it leads to was clicked. */
  take(link: Element): void {
    const name = link.getAttribute('download') ?? '';
    const blob = this.#blobs.get(link.getAttribute('href') ?? '');
    this.#waiting.shift()?.({
      suggestedFilename: () => name,
      path: async () => {
        this.#folder ??= mkdtempSync(join(tmpdir(), 'framewright-'));
        const path = join(this.#folder, name);
        writeFileSync(path, new Uint8Array((await blob?.arrayBuffer()) ?? []));
        return path;
      },
    });
  }

  clear(): void {
    if (this.#folder !== undefined) rmSync(this.#folder, { recursive: true });
  }
}
