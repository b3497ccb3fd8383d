import { signal } from '@preact/signals';
import type { Reading } from '../../../modbus/index.ts';
import { KeptChoice } from '../../../store/index.ts';
import { type CopyFormat, canCopyAs, firstCopyFormat, readCopyFormat } from '../../../workbench/index.ts';
import { storage } from '../store.ts';

/** The format copied last. */
export const lastFormat = new KeptChoice<CopyFormat>(storage, 'copy', firstCopyFormat, readCopyFormat);

/** Whether the checksum is copied with the frame. It is again when the page is loaded again. */
export const withChecksum = signal(true);

/** The format copied last, or the first one if the frame has no such form. */
export const formatFor = (reading: Reading | undefined): CopyFormat =>
  reading === undefined || canCopyAs(reading, lastFormat.value) ? lastFormat.value : firstCopyFormat;

/** A text, or its beginning if it is longer than that. */
export const shorten = (text: string, most: number): string => (text.length > most ? `${text.slice(0, most)}…` : text);
