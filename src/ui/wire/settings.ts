import {
  readSerialFormat,
  type SerialFormat,
  type SerialLine,
  type SerialMode,
  serialFormatName,
} from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { chosenProfile } from '../device/chosen.ts';
import { Remembered } from '../tools/remembered.ts';
import { type LevelKind, levelKinds } from './picture/geometry.ts';

/** How the line was set last. */
interface LineSettings {
  /** The device it was set for, by its id; blank for none. */
  readonly device: string;
  readonly baud: number;
  /** The names of the formats of either mode. */
  readonly rtu: string;
  readonly ascii: string;
  readonly level: LevelKind;
  /** Milliseconds until the device answers. */
  readonly delay: number;
}

const FIRST: LineSettings = { device: '', baud: 19_200, rtu: '8E1', ascii: '7E1', level: 'rs485', delay: 5 };

const LEAST_BAUD = 50;
const MOST_BAUD = 4_000_000;
const MOST_MILLISECONDS = 2000;

/** A speed as typed, in decimal or hexadecimal. */
export function readSpeed(text: string): number | undefined {
  const speed = readNumber(text);
  return speed !== undefined && Number.isInteger(speed) && speed >= LEAST_BAUD && speed <= MOST_BAUD
    ? speed
    : undefined;
}

/** A time in milliseconds as typed. */
export function readMilliseconds(text: string): number | undefined {
  const time = readNumber(text.replace(/\s*ms$/i, ''));
  return time !== undefined && time >= 0 && time <= MOST_MILLISECONDS ? time : undefined;
}

const remembered = new Remembered<LineSettings>('wire-line', FIRST, (value) => {
  const { device, baud, rtu, ascii, level, delay } = { ...FIRST, ...(value as Partial<LineSettings> | null) };
  const good =
    typeof device === 'string' &&
    readSpeed(String(baud)) !== undefined &&
    readSerialFormat(String(rtu)) !== undefined &&
    readSerialFormat(String(ascii)) !== undefined &&
    Object.hasOwn(levelKinds, level) &&
    readMilliseconds(String(delay)) !== undefined;
  return good ? { device, baud, rtu, ascii, level, delay } : undefined;
});

export interface LineChoice {
  readonly serial: SerialLine;
  readonly level: LevelKind;
  readonly delay: number;
  /** The name of the device whose settings these are. */
  readonly device: string | undefined;
}

/** How the line is set: as it was last, but for another device than then as that device has it. */
export function lineChoice(mode: SerialMode): LineChoice {
  const { device, baud, level, delay, ...formats } = remembered.value;
  const profile = chosenProfile();
  const format = readSerialFormat(formats[mode]) as SerialFormat;
  const theirs = profile?.serial && profile.id !== device ? profile : undefined;
  const serial = theirs?.serial ?? { baud, ...format };
  return { serial, level, delay, device: theirs?.name };
}

/** Sets something of the line, and remembers it, for the device that is chosen now. */
export function setLine(mode: SerialMode, changed: Partial<Omit<LineChoice, 'device'>>): void {
  const { serial, level, delay } = { ...lineChoice(mode), ...changed };
  remembered.value = {
    ...remembered.value,
    device: chosenProfile()?.id ?? '',
    baud: serial.baud,
    [mode]: serialFormatName(serial),
    level,
    delay,
  };
}
