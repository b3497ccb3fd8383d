import { strToU8, zipSync } from 'fflate';

export type Texts = readonly { readonly path: string; readonly text: string }[];

/** Texts as one zip, each under its path. */
export const zipOf = (files: Texts): Uint8Array<ArrayBuffer> =>
  zipSync(Object.fromEntries(files.map(({ path, text }) => [path, strToU8(text)])));
