import type { BusWords } from './en/bus.ts';
import type { CompareWords } from './en/compare.ts';
import type { ListenWords } from './en/listen.ts';
import type { ScanWords } from './en/scan.ts';
import type { SequenceWords } from './en/sequence.ts';
import type { ValueWords } from './en/values.ts';
import type { VirtualWords } from './en/virtual.ts';
import type { WireWords } from './en/wire.ts';

// Loaders of sentences that come after the first view. In a file of their own, because what loads at first holds whole files.

/** What the comparison of two frames says, which comes with it. */
export const loadCompareWords = (): Promise<CompareWords> => import('./en/compare.ts').then(({ compare }) => compare);

/** The sentences about values in registers, which come with the views for them. */
export const loadValueWords = (): Promise<ValueWords> => import('./en/values.ts').then(({ values }) => values);

/** What is said about a frame on its line, which comes when that is opened. */
export const loadWireWords = (): Promise<WireWords> => import('./en/wire.ts').then(({ wire }) => wire);

/** What the bus says, which comes when its view is opened. */
export const loadBusWords = (): Promise<BusWords> => import('./en/bus.ts').then(({ bus }) => bus);

/** What the virtual devices say, which comes with their panel. */
export const loadVirtualWords = (): Promise<VirtualWords> => import('./en/virtual.ts').then(({ virtual }) => virtual);

/** What scanning says, which comes with its panel. */
export const loadScanWords = (): Promise<ScanWords> => import('./en/scan.ts').then(({ scan }) => scan);

/** What listening says, which comes with its panel. */
export const loadListenWords = (): Promise<ListenWords> => import('./en/listen.ts').then(({ listen }) => listen);

/** What the panel of sequences says, which comes when it is opened. */
export const loadSequenceWords = (): Promise<SequenceWords> =>
  import('./en/sequence.ts').then(({ sequence }) => sequence);
