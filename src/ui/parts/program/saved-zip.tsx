import { strToU8, zipSync } from 'fflate';
import { useEffect } from 'preact/hooks';
import { download } from '../../kit/download.ts';

/** Texts that are saved as one file, each under its path. A new object is saved anew. */
export interface Zip {
  readonly texts: readonly { readonly path: string; readonly text: string }[];
  readonly name: string;
}

/** Saves the texts. Shows nothing. */
export function SavedZip({ zip }: { readonly zip: Zip }) {
  useEffect(() => {
    const files = Object.fromEntries(zip.texts.map(({ path, text }) => [path, strToU8(text)]));
    download(zipSync(files), zip.name, 'application/zip');
  }, [zip]);
  return null;
}
