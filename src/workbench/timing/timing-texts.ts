import { LAST_UNIT, readSerialFormat } from '../../modbus/index.ts';
import { record, text } from '../stored.ts';
import { isTime, isWhole, LEAST_BAUD, MOST_BAUD, type TimingName, type TimingTexts } from './timing-entries.ts';

/** A line that has the defaults of the specification (SL 2.5.1, SL 3.2), and ten devices on it. */
export const firstTimingTexts: TimingTexts = {
  mode: '',
  baud: '19200',
  format: '8E1',
  counted: 'format',
  request: '',
  reply: '',
  delay: '0 ms',
  turnaround: '100 ms',
  devices: '10',
  missing: '0',
  timeout: '1 s',
  gap: '1 ms',
};
const names = Object.keys(firstTimingTexts) as TimingName[];

/** The texts by their names; one that is `undefined` is taken from `otherwise`. */
export function timingTexts(textOf: (name: TimingName) => string | undefined, otherwise: TimingTexts): TimingTexts {
  const entries = names.map((name) => [name, textOf(name) ?? otherwise[name]]);
  return Object.fromEntries(entries) as unknown as TimingTexts;
}

/** What is kept for the next time: the line and the devices, but nothing that belongs to the current frame. */
export const keptTexts = (texts: TimingTexts): TimingTexts => ({ ...texts, mode: '', request: '', reply: '' });

const nothing = text((typed) => typed === '');
const time = text(isTime);

/** The texts kept last; one that is missing or not legal is as in `firstTimingTexts`. */
export const storedTexts = record<TimingTexts>(
  {
    mode: nothing,
    baud: text((typed) => isWhole(typed, LEAST_BAUD, MOST_BAUD)),
    format: text((typed) => readSerialFormat(typed) !== undefined),
    counted: text((typed) => typed === 'format' || typed === '11'),
    request: nothing,
    reply: nothing,
    delay: time,
    turnaround: time,
    devices: text((typed) => isWhole(typed, 1, LAST_UNIT)),
    missing: text((typed) => isWhole(typed, 0, LAST_UNIT)),
    timeout: time,
    gap: time,
  },
  firstTimingTexts,
);
