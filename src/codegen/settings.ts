import type { ProgramOptions } from './options.ts';
import type { Settings } from './plan.ts';

/** What a serial line is set to by default (SL 2.5.1). */
const LINE: Settings['line'] = { port: '/dev/ttyUSB0', baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 };
const SERVER: Settings['server'] = { host: '192.168.0.10', port: 502 };
const TIMEOUT = 1000;

/** What programs have where nothing is set. */
export const usualProgram = { line: LINE, server: SERVER, timeout: TIMEOUT } as const;

/** What is given, and what is usual where nothing is. */
function filled<T extends object>(usual: T, given: { readonly [Name in keyof T]?: T[Name] | undefined } = {}): T {
  const set = Object.entries(given).filter(([name, value]) => value !== undefined && Object.hasOwn(usual, name));
  return { ...usual, ...Object.fromEntries(set) };
}

/** The options with everything filled in: the line as the device has it. */
export function settingsOf(options: ProgramOptions = {}): Settings {
  const { profile } = options;
  return {
    part: options.part ?? 'exchange',
    crc: options.crc ?? 'bitwise',
    comments: options.comments ?? true,
    name: options.name,
    names: options.names ?? {},
    profile,
    units: options.units ?? false,
    echo: options.echo ?? false,
    timeout: options.timeout ?? TIMEOUT,
    line: filled(filled(LINE, profile?.serial), options.line),
    server: filled(SERVER, options.server),
  };
}
