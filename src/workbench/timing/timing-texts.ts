import { LAST_UNIT, readSerialFormat, type SerialLine, serialFormatName } from '../../modbus/index.ts';
import { readSpeed } from '../line/line-setting.ts';
import { record, text } from '../stored.ts';
import { isTime, isWhole, type TimingName, type TimingTexts } from './timing-entries.ts';

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

/** The texts of the line that everything on the page goes by. */
export const lineTexts = (line: SerialLine): Pick<TimingTexts, 'baud' | 'format'> => ({
  baud: String(line.baud),
  format: serialFormatName(line),
});

/** What the texts say of the line, as far as it is legal. */
export function saidOfLine({ baud, format }: Pick<TimingTexts, 'baud' | 'format'>): Partial<SerialLine> {
  const speed = readSpeed(baud);
  return { ...(speed === undefined ? {} : { baud: speed }), ...readSerialFormat(format) };
}

/** What is kept for the next time: the devices, but nothing of the current frame, and nothing of the line, which is kept for all. */
export const keptTexts = (texts: TimingTexts): TimingTexts => {
  const { baud, format, mode, request, reply } = firstTimingTexts;
  return { ...texts, baud, format, mode, request, reply };
};

const nothing = text((typed) => typed === '');
const time = text(isTime);

/** The texts kept last; one that is missing or not legal is as in `firstTimingTexts`. */
export const storedTexts = record<TimingTexts>(
  {
    mode: nothing,
    baud: text((typed) => typed === firstTimingTexts.baud),
    format: text((typed) => typed === firstTimingTexts.format),
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
