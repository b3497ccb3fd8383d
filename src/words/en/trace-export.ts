import type { ExportFormat, Replaced, RowUnit } from '../../workbench/index.ts';
import { bytesOf, grouped, plural } from './common.ts';

/** What the dialog says that saves a log. */
export const traceExport = {
  open: 'Save…',
  title: 'Save the log',
  format: 'Save as',
  formats: { pcapng: 'capture', csv: 'table', json: 'JSON', report: 'report' } satisfies Record<ExportFormat, string>,
  formatHints: {
    pcapng:
      'A pcapng file, which Wireshark opens. It knows no ASCII mode: such frames are saved as the RTU frames that say the same.',
    csv: 'A CSV file for a spreadsheet, a line for each frame. This page opens it again.',
    json: 'A file for programs, with everything that is known of each frame. This page opens it again.',
    report:
      'Markdown to paste into a ticket: what is in the log, what explains its faults, the first 100 faults with their frames, and statistics by unit.',
  } satisfies Record<ExportFormat, string>,
  which: 'Frames',
  all: (frames: number) => `all ${grouped(frames)}`,
  filtered: (rows: number, by: RowUnit) => `of the filter: ${plural(rows, by)}`,
  replace: 'Replace',
  replaced: {
    units: 'unit numbers: they are numbered from 1 in the order in which they speak',
    addresses: 'addresses: in each table the lowest one becomes 0, and hosts become 192.0.2.1 and so on',
    times: 'times: they count from the first frame',
  } satisfies Record<keyof Replaced, string>,
  /** What is kept while something is replaced. */
  kept: 'Values stay as they are. A damaged frame becomes zeros, unless its request or its reply confirms it. The names of a device, of the file and the filter are left out.',
  save: 'Save file',
  copy: 'Copy',
  making: 'Making the file',
  made: (percent: number) => `${percent} %`,
  cancel: 'Cancel',
  close: 'Close',
  saved: (name: string, frames: number, size: number) =>
    `Saved as ${name}: ${plural(frames, 'frame')}, ${bytesOf(size)}.`,
  copied: (frames: number) => `Copied: a report of ${plural(frames, 'frame')}.`,
  notMade: {
    'given-up': 'Not saved.',
    failed: 'A part of this page did not come, perhaps because there is no connection. Try it again.',
  },
  refused: 'The browser does not let this page copy. Save the file instead.',
};
