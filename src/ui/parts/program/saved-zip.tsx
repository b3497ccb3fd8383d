import { useEffect } from 'preact/hooks';
import { download } from '../../kit/download.ts';
import { type Texts, zipOf } from './zip.ts';

/** Files that are saved as one, each time with other texts. */
export interface Zip {
  readonly texts: Texts;
  readonly name: string;
}

/** Saves the files. Shows nothing. */
export function SavedZip({ zip }: { readonly zip: Zip }) {
  useEffect(() => download(zipOf(zip.texts), zip.name, 'application/zip'), [zip]);
  return null;
}
