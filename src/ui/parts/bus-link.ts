import { signal } from '@preact/signals';
import type { LinkState } from '../../bus/index.ts';

/** How the line of the bus stands, for the header of every view. The bus itself comes with its view, and writes this. */
export const busLink = signal<LinkState>({ kind: 'closed' });
