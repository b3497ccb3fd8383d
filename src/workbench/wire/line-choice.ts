import {
  readSerialFormat,
  type SerialFormat,
  type SerialLine,
  type SerialMode,
  serialFormatName,
} from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { number, oneOf, record, text, whole } from '../stored.ts';
import { type LevelKind, levelKinds } from './geometry.ts';

/** How the line was set last. */
export interface LineMemory {
  /** The device it was set for, by its id; blank for no device. */
  readonly device: string;
  readonly baud: number;
  /** The names of the formats of either mode. */
  readonly rtu: string;
  readonly ascii: string;
  readonly level: LevelKind;
  /** Milliseconds until the device answers. */
  readonly delay: number;
}

/** The defaults of the specification (SL 2.5.1, SL 2.5.2, SL 3.2), on RS-485. */
export const firstLine: LineMemory = {
  device: '',
  baud: 19_200,
  rtu: '8E1',
  ascii: '7E1',
  level: 'rs485',
  delay: 5,
};

const LEAST_BAUD = 50;
const MOST_BAUD = 4_000_000;
const MOST_MILLISECONDS = 2000;

const format = text((name) => readSerialFormat(name) !== undefined);

/** The line kept last; a part that is missing or not legal is as in `firstLine`. */
export const storedLine = record<LineMemory>(
  {
    device: text(),
    baud: whole(LEAST_BAUD, MOST_BAUD),
    rtu: format,
    ascii: format,
    level: oneOf(Object.keys(levelKinds) as LevelKind[]),
    delay: number(0, MOST_MILLISECONDS),
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

/** A time in milliseconds as typed. */
export function readMilliseconds(typed: string): number | undefined {
  const time = readNumber(typed.replace(/\s*ms$/i, ''));
  return time !== undefined && time >= 0 && time <= MOST_MILLISECONDS ? time : undefined;
}

/** The byte that a gap precedes, as typed: 1 to `last`. A blank text means no gap; `undefined` for any other text. */
export function readGapAt(typed: string, last: number): { readonly gapAt: number | undefined } | undefined {
  if (typed.trim() === '') return { gapAt: undefined };
  const at = readNumber(typed);
  return at !== undefined && Number.isInteger(at) && at >= 1 && at <= last ? { gapAt: at } : undefined;
}

/** A device with the line that its manual names, if it names one. */
interface DeviceLine {
  readonly id: string;
  readonly name: string;
  readonly serial?: SerialLine | undefined;
}

export interface LineChoice {
  readonly serial: SerialLine;
  readonly level: LevelKind;
  readonly delay: number;
  /** The name of the device whose settings these are. */
  readonly device: string | undefined;
}

/** How the line is set: as it was last, but for another device than then as that device has it. */
export function lineChoice(memory: LineMemory, mode: SerialMode, device: DeviceLine | undefined): LineChoice {
  const { baud, level, delay } = memory;
  const theirs = device?.serial && device.id !== memory.device ? device : undefined;
  const serial = theirs?.serial ?? { baud, ...(readSerialFormat(memory[mode]) as SerialFormat) };
  return { serial, level, delay, device: theirs?.name };
}

/** What is kept after something of the line was set for the device that is chosen now. */
export function withLine(
  memory: LineMemory,
  mode: SerialMode,
  device: DeviceLine | undefined,
  changed: Partial<Omit<LineChoice, 'device'>>,
): LineMemory {
  const { serial, level, delay } = { ...lineChoice(memory, mode, device), ...changed };
  const { baud } = serial;
  return { ...memory, device: device?.id ?? '', baud, [mode]: serialFormatName(serial), level, delay };
}
