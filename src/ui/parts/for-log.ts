import { signal } from '@preact/signals';
import { page } from './store.ts';

/** A file or a text that the Log view opens when it has come. */
export const forLog = signal<File | string | undefined>(undefined);

export function openInLog(what: File | string): void {
  forLog.value = what;
  page.open('log');
}
