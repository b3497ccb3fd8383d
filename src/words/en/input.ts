import type { ChipId } from '../../workbench/index.ts';
import { sizeOf } from './numbers.ts';

/** What stands at the input before anything is read. */
export const input = {
  section: 'Input',
  label: 'A frame, a log or code',
  hint: 'Paste or type: a frame in any notation, a log, code, 40108, P0683 30 Hz, “write registers”',
  openFile: 'Open file…',
  clear: 'Clear',
  isEmpty: 'Nothing to clear.',
  /** Of a text that is too long for its field. */
  beginning: (characters: number) => `The beginning of ${sizeOf(characters)}. All of it is read.`,
  stays: 'Or drop a file. Nothing leaves this browser.',
  /** Before the examples that one click puts into the input. */
  tryThis: 'Try',
  chips: {
    'set-30-hz': 'set 30 Hz',
    'wrong-crc': 'a wrong CRC',
    'float-reply': 'a float in a reply',
    'faulty-log': 'a log with faults',
  } satisfies Record<ChipId, string>,
  drawer: {
    open: 'All examples and saved frames',
    title: 'Examples and saved frames',
    close: 'Close',
    examples: 'Examples',
    /** The tab of the saved frames. */
    saved: (count: number) => (count > 0 ? `Saved frames (${count})` : 'Saved frames'),
    copy: 'Copy',
    copyOf: (name: string) => `Copy ${name}`,
  },
};
