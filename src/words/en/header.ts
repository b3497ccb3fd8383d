import type { SerialLine } from '../../modbus/index.ts';
import { views } from './common.ts';

/** What is said in the boxes that the header opens. */
export const header = {
  search: 'Search devices',
  nothingFound: 'No device has this in its name or its source.',
  lineIntro: 'For the picture on the wire, the timing, and the bus.',
  baud: 'Speed (baud)',
  baudWrong: 'A whole number from 50 to 4,000,000, decimal or hexadecimal (0x…).',
  dataBits: 'Data bits',
  parity: 'Parity',
  parities: { none: 'none', even: 'even', odd: 'odd' },
  stopBits: 'Stop bits',
  ownLine: (name: string, line: SerialLine) => `${name}: ${views.lineName(line)}`,
  useOwn: 'Use it',
  isOwn: 'This is the setting of the device’s manual.',
  later: (line: SerialLine) => `Connected with ${views.lineName(line)}. A change applies at the next connection.`,
};
