import { parities, readSerialFormat, type SerialLine, serialFormatName } from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { oneOf, record, text, whole } from '../stored.ts';

/** The speeds that a line may have, in bits a second. */
export const LEAST_BAUD = 50;
export const MOST_BAUD = 4_000_000;

/** How the line was set last. */
export interface LineMemory extends SerialLine {
  /** The device it was set for, by its id; blank for no device. */
  readonly device: string;
}

/** The default of the specification (SL 2.5.1, SL 3.2). */
export const firstLine: LineMemory = { device: '', baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 };

/** The line kept last; a part that is missing or not legal is as in `firstLine`. */
export const storedLine = record<LineMemory>(
  {
    device: text(),
    baud: whole(LEAST_BAUD, MOST_BAUD),
    dataBits: oneOf([7, 8]),
    parity: oneOf(parities),
    stopBits: oneOf([1, 2]),
  },
  firstLine,
);

/** A speed as typed, in decimal or hexadecimal. */
export function readSpeed(typed: string): number | undefined {
  const speed = readNumber(typed);
  return speed !== undefined && Number.isInteger(speed) && speed >= LEAST_BAUD && speed <= MOST_BAUD
    ? speed
    : undefined;
}

/** A line as links have it: `9600-8N1`. */
export const lineText = (line: SerialLine): string => `${line.baud}-${serialFormatName(line)}`;

/** The line that a text such as `9600-8N1` or `9600 8N1` names; `undefined` if it names none. */
export function readLineText(typed: string): SerialLine | undefined {
  const [, speed = '', name = ''] = typed.trim().match(/^(\d+)[-\s]+(\S+)$/) ?? [];
  const [baud, format] = [readSpeed(speed), readSerialFormat(name)];
  return baud === undefined || format === undefined ? undefined : { baud, ...format };
}

/** A device with the line that its manual names, if it names one. */
export interface DeviceLine {
  readonly id: string;
  readonly name: string;
  readonly serial?: SerialLine | undefined;
}

/** The line alone, without what else is known of it. */
export const lineOf = ({ baud, dataBits, parity, stopBits }: SerialLine): SerialLine => ({
  baud,
  dataBits,
  parity,
  stopBits,
});

/** How the line is set: as it was last, but for another device than then as that device has it. */
export const lineFor = (memory: LineMemory, device: DeviceLine | undefined): SerialLine =>
  lineOf(device?.serial && device.id !== memory.device ? device.serial : memory);
