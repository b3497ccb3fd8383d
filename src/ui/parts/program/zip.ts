import { strToU8, zipSync } from 'fflate';

/** Texts as one zip, each under its path. */
export const zipOf = (files: readonly { readonly path: string; readonly text: string }[]): Uint8Array<ArrayBuffer> =>
  zipSync(Object.fromEntries(files.map(({ path, text }) => [path, strToU8(text)])));
