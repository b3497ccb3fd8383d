import type { Register } from '../../devices/index.ts';
import type { MapImportWay, MapValue, ReadFailure, ReadingProgress } from '../../workbench/index.ts';
import { capital, grouped, plural } from './common.ts';
import { poll } from './poll.ts';
import { failureName } from './sent.ts';

const valueRead = ({ raw, power }: Extract<MapValue, { kind: 'value' }>, register: Register) =>
  raw === undefined ? `no value of ${register.type}` : poll.reading(raw, register, power);

/** The Devices view: all profiles, the map of the chosen one, and the import of maps. */
export const library = {
  title: 'Devices: register maps with names, types and units. Framewright',
  profiles: 'Library',
  search: 'Search all devices',
  searchHint: 'voltage, 30003, 0x0000',
  found: (registers: number, devices: number) => `${plural(registers, 'register')} in ${plural(devices, 'device')}`,
  count: (registers: number) => plural(registers, 'register'),
  builtIn: 'built in',
  own: 'your own',
  inLink: 'in the link',
  map: (name: string) => `The map of ${name}`,
  noMap: 'Choose a device on the left, or import its map.',
  import: 'Import a map',
  importHint:
    'A table of registers as its maker has it: CSV, Excel (.xlsx), Markdown, HTML, JSON, YAML, or cells copied from a spreadsheet. Drop the file here, or paste.',
  chooseFile: 'Choose a file…',
  tooBig: 'The file has more than 50 MB. A register map is smaller: nothing was read.',
  unread: 'The browser could not read the file.',
  reading: (name: string) => `Reading ${name}…`,
  pastedName: 'Pasted map',
  assistant: (name: string) => `Import of ${name}`,
  result: (registers: number, lost: number, doubtful: number) =>
    [
      `${plural(registers, 'register')} read`,
      ...(lost > 0 ? [`${plural(lost, 'row')} not imported`] : []),
      ...(doubtful > 0 ? [`${plural(doubtful, 'register')} with a doubt`] : []),
    ].join(' · '),
  questions: 'What the file does not say',
  columns: 'What each column is taken for',
  column: (at: number, header: string) => `Column ${at}${header === '' ? '' : `, ${header}`}`,
  registers: 'The first registers, as they are read',
  registerColumns: ['Name', 'Table', 'Address', 'Type', 'Scale', 'Access'],
  notImported: 'Not imported',
  doubts: 'Imported with a doubt',
  nothing: 'No register was found in it.',
  keep: 'Import',
  cancel: 'Cancel',
  way: (name: string) => `“${name}” is there already`,
  ways: {
    add: 'Add it beside the other',
    update: 'Update the other by address; registers that are only there stay',
    replace: 'Replace the other',
  } satisfies Record<MapImportWay, string>,
  imported: (name: string, count: number) => `“${name}”: ${plural(count, 'register')} imported.`,
  readAll: (count: number) => `Read all (${grouped(count)})`,
  cancelReading: 'Stop reading',
  readHint: (gap: number) =>
    gap === 0
      ? 'In as few requests as the device allows.'
      : `In as few requests as the device allows; gaps of up to ${gap} addresses between registers are read too.`,
  unit: 'Unit of the device',
  unitWrong: (least: number, most: number) => `A whole number from ${least} to ${most}.`,
  readOnceOpen: 'The connection is being opened: the registers are read as soon as it is there.',
  nothingToRead: 'None of these registers can be read.',
  toBus: 'Connect on the Bus',
  toVirtual: 'Use the virtual bus',
  readingNow: (done: number, left: number) => `${grouped(done)} of ${plural(done + left, 'request')}`,
  readResult: ({ read, failed, left, wanted }: ReadingProgress) =>
    [
      `${grouped(read)} of ${plural(wanted, 'value')} read.`,
      ...(failed > 0 ? [`${grouped(failed)} ${failed === 1 ? 'was' : 'were'} not; the rows say why.`] : []),
      ...(left > 0 ? [`${plural(left, 'request')} ${left === 1 ? 'was' : 'were'} not sent.`] : []),
    ].join(' '),
  readEnded: {
    stopped: '',
    lost: 'The adapter was lost.',
    disconnected: 'The connection was closed.',
    declined: 'Nothing was read.',
  },
  failure: (failure: ReadFailure) =>
    failure.exceptionCode === undefined ? failureName(failure) : capital(failureName(failure)),
  values: (register: Register, values: readonly MapValue[], isAll: boolean) =>
    [
      ...values.flatMap((one) => (one.kind === 'value' ? [valueRead(one, register)] : [])),
      ...(isAll ? [] : ['…']),
    ].join('; '),
  compare: 'Compare with',
  compareNone: 'another device',
  same: 'Both maps say the same.',
  differences: (count: number) => plural(count, 'difference'),
  place: 'Register',
  missing: 'not there',
};
