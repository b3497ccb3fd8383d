import {
  type CrcWay,
  crcWays,
  type ProgramOptions,
  type ProgramPart,
  programParts,
  usualProgram,
} from '../../codegen/index.ts';
import type { Profile } from '../../devices/index.ts';
import type { SerialLine } from '../../modbus/index.ts';
import { type Decoder, flag, oneOf, record, text, whole } from '../stored.ts';

/** Longest name, port or host, in characters, and longest list of names. */
const LONGEST = 200;
const LONGEST_LIST = 4000;
/** Time-outs that can be set, in milliseconds. */
export const LEAST_TIMEOUT = 1;
export const MOST_TIMEOUT = 600_000;
export const MOST_PORT = 65_535;

/** How programs are written, as it is set and kept. Blank texts are as usual. */
export interface ProgramSettings {
  readonly crc: CrcWay;
  readonly comments: boolean;
  readonly units: boolean;
  readonly echo: boolean;
  /** In milliseconds. */
  readonly timeout: number;
  /** Names of one's own, one a line: `start_address = first`. */
  readonly names: string;
  /** The serial port. */
  readonly port: string;
  readonly host: string;
  readonly tcpPort: number;
}

export const firstProgramSettings: ProgramSettings = {
  crc: 'bitwise',
  comments: true,
  units: false,
  echo: false,
  timeout: usualProgram.timeout,
  names: '',
  port: '',
  host: '',
  tcpPort: usualProgram.server.port,
};

const short = text((given) => given.length <= LONGEST);

export const storedProgramSettings: Decoder<ProgramSettings> = record(
  {
    crc: oneOf(crcWays),
    comments: flag,
    units: flag,
    echo: flag,
    timeout: whole(LEAST_TIMEOUT, MOST_TIMEOUT),
    names: text((given) => given.length <= LONGEST_LIST),
    port: short,
    host: short,
    tcpPort: whole(1, MOST_PORT),
  },
  firstProgramSettings,
);

/** The names of a list, and the lines, from 1, that are not `name = another`. */
export function readOwnNames(list: string): {
  readonly names: Readonly<Record<string, string>>;
  readonly faults: readonly number[];
} {
  const names = new Map<string, string>();
  const faults: number[] = [];
  for (const [index, line] of list.split('\n').entries()) {
    if (line.trim() === '') continue;
    const [, from, to] = /^\s*([^=]+?)\s*=\s*(\S.*?)\s*$/.exec(line) ?? [];
    if (from === undefined || to === undefined) faults.push(index + 1);
    else names.set(from, to);
  }
  return { names: Object.fromEntries(names), faults };
}

/** The target, and what of it is wanted. */
export interface ProgramChoice {
  readonly target: string;
  readonly part: ProgramPart;
}

export const firstProgramChoice: ProgramChoice = { target: 'structured-text', part: 'exchange' };

/** A choice as links have it: `c.check`. */
export const programChoiceText = ({ target, part }: ProgramChoice): string => `${target}.${part}`;

/** Reads what `programChoiceText` wrote; `undefined` if it names no part. Whether there is such a target is another question. */
export function readProgramChoice(given: string): ProgramChoice | undefined {
  const [, target, name] = /^([a-z\d-]{1,40})\.([a-z]+)$/.exec(given) ?? [];
  const part = programParts.find((known) => known === name);
  return target === undefined || part === undefined ? undefined : { target, part };
}

/** What a program depends on beside its frame and what is set for it. */
export interface ProgramSurroundings {
  readonly profile: Profile | undefined;
  readonly line: SerialLine;
}

/** The options of `writeProgram`. */
export function programOptions(
  part: ProgramPart,
  { names, port, host, tcpPort, units, ...settings }: ProgramSettings,
  { profile, line }: ProgramSurroundings,
  name = '',
): ProgramOptions {
  return {
    ...settings,
    part,
    profile,
    units: units && profile !== undefined,
    name: name.trim() || undefined,
    names: readOwnNames(names).names,
    line: { ...line, port: port.trim() || undefined },
    server: { host: host.trim() || undefined, port: tcpPort },
  };
}
