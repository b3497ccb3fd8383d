import type { BadRow, FileFault, Refusal, RowFault } from '../../workbench/index.ts';
import { plural } from './common.ts';

function fileFault(fault: FileFault): string {
  switch (fault.code) {
    case 'not-json':
      return `It is not JSON: ${fault.detail}`;
    case 'not-saved-frames':
      return 'It is JSON, but not a list of saved frames.';
    case 'too-deep':
      return `It has lists or objects inside each other, more than ${fault.most} deep.`;
    case 'newer-version':
      return `It has version ${fault.version}; this page knows version 1. A newer page can read it.`;
  }
}

const rowFaults: Record<RowFault, string> = {
  'not-a-row': 'is not made of a name and a link',
  'no-name': 'has no name',
  'name-too-long': 'has a name of more than 200 characters',
  'no-link': 'has no link',
  'unknown-link': 'has a link that means nothing here',
  'newer-link': 'has a link from a newer version of this page',
};

/** What the saved frames say. */
export const saved = {
  intro: 'Kept under a name in this browser, valid or not. Export them to keep them elsewhere.',
  name: 'Name of this frame',
  nameMissing: 'A name has at least one character other than a blank.',
  save: 'Save this frame',
  list: 'Saved frames',
  empty: 'None yet.',
  noFrame: (wrong: number) => `No frame: ${plural(wrong, 'value')} cannot be sent.`,
  rename: 'Rename',
  renameOf: (name: string) => `Rename ${name}`,
  newName: (name: string) => `New name of ${name}`,
  keepName: 'Keep',
  cancel: 'Cancel',
  remove: 'Delete',
  removeOf: (name: string) => `Delete ${name}`,
  undo: (name: string) => `Undo: bring ${name} back`,
  choose: (name: string) => `Choose ${name}`,
  /** On buttons with a list of formats. */
  copyAll: (count: number) => `Copy all ${count} as`,
  copyAllOf: (count: number, source: string) => `Copy all ${count} as, ${source}`,
  copyChosen: (count: number) => `Copy ${count} chosen as`,
  programOfAll: (count: number) => (count === 1 ? 'Program' : `Program of all ${count}`),
  programOfChosen: (count: number) => `Program of ${count} chosen`,
  export: 'Export all',
  import: 'Import a file',
  fileName: 'framewright-frames.json',
  savedAs: (name: string) => `Saved as “${name}”.`,
  renamedTo: (name: string) => `Renamed to “${name}”.`,
  nameTaken: (wanted: string, got: string) => `“${wanted}” is taken, and stays: the other is kept as “${got}”.`,
  removed: (name: string) => `“${name}” is deleted.`,
  restored: (name: string) => `“${name}” is back.`,
  exported: (count: number) => `${plural(count, 'frame')} written to framewright-frames.json.`,
  imported: (count: number) => `${plural(count, 'frame')} imported.`,
  already: (count: number) => `${plural(count, 'frame')} ${count === 1 ? 'was' : 'were'} here already, unchanged.`,
  badRow: (row: number, why: RowFault) => `Not imported: row ${row} ${rowFaults[why]}.`,
  badFile: (name: string, fault: FileFault) => `Nothing imported from ${name}. ${fileFault(fault)}`,
  fileTooBig: (name: string) => `Nothing imported from ${name}. It has more than 5 MB.`,
  fileUnread: (name: string) => `Nothing imported from ${name}. The browser could not read it.`,
  refusals: {
    refused:
      'Not stored: this browser allows this page no storage (a private window, or a setting). Nothing was changed.',
    full: 'Not stored: the storage that this browser gives the page is full. Nothing was changed. Export frames and delete some, then try again.',
    unreadable: 'It is left as it is, and nothing is saved over it.',
    gone: 'This frame is no longer here: another tab deleted or renamed it.',
  } satisfies Record<Refusal, string>,
  unreadable: (fault: FileFault) =>
    `What this browser stored under this page cannot be read. ${fileFault(fault)} It is left as it is, and nothing is saved over it.`,
  badItems: (count: number) => `${plural(count, 'row')} in the storage cannot be read. They are kept as they are:`,
  badItem: ({ row, why }: BadRow) => `Row ${row} ${rowFaults[why]}.`,
  download: 'Download it',
  setAside: 'Set it aside and start again',
  setAsideAs: (key: string) => `Set aside in the storage as “${key}”.`,
};
