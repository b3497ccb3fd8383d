/** How a character is checked. */
export type Parity = (typeof parities)[number];
export const parities = ['none', 'even', 'odd'] as const;

/** What a character on a serial line is made of, besides its start bit (SL 2.5.1, 2.5.2). */
export interface SerialFormat {
  readonly dataBits: 7 | 8;
  readonly parity: Parity;
  readonly stopBits: 1 | 2;
}

/** How a serial line is set. */
export interface SerialLine extends SerialFormat {
  /** Bits a second. */
  readonly baud: number;
}

/** The two transmission modes of a serial line (SL 2.5). */
export type SerialMode = 'rtu' | 'ascii';

const DATA_BITS = [8, 7] as const;
const STOP_BITS = [1, 2] as const;
const LETTERS: Readonly<Record<Parity, string>> = { none: 'N', even: 'E', odd: 'O' };

/** All formats there can be, those of eight data bits first. */
export const serialFormats: readonly SerialFormat[] = DATA_BITS.flatMap((dataBits) =>
  parities.flatMap((parity) => STOP_BITS.map((stopBits) => ({ dataBits, parity, stopBits }))),
);

/** The usual name of a format: `8E1`. */
export const serialFormatName = ({ dataBits, parity, stopBits }: SerialFormat): string =>
  `${dataBits}${LETTERS[parity]}${stopBits}`;

/** The format of this name, in upper or lower case, perhaps with `-`, `,` or blanks between its parts. */
export function readSerialFormat(text: string): SerialFormat | undefined {
  const name = text.replace(/[\s,-]/g, '').toUpperCase();
  return serialFormats.find((format) => serialFormatName(format) === name);
}

const START_BITS = 1;

/** Throws a `RangeError` for a format that is not one of `serialFormats`. */
export function demandFormat({ dataBits, parity, stopBits }: SerialFormat): void {
  const [data, checks, stops]: readonly (readonly unknown[])[] = [DATA_BITS, parities, STOP_BITS];
  if (!data?.includes(dataBits) || !checks?.includes(parity) || !stops?.includes(stopBits)) {
    throw new RangeError(`no serial format: ${dataBits} data bits, parity ${parity}, ${stopBits} stop bits`);
  }
}

/** Bits of a character: start, data, parity, stop. Throws a `RangeError` for a format that is not one of these. */
export function bitsPerCharacter(format: SerialFormat): number {
  demandFormat(format);
  const { dataBits, parity, stopBits } = format;
  return START_BITS + dataBits + (parity === 'none' ? 0 : 1) + stopBits;
}

/**
 * The standing of a format in a transmission mode: the default that every device must support; one that the specification
 * also names; one in common use that it does not name; an unusual one; one that is too narrow for the frame's bytes.
 */
export type FormatStanding = 'default' | 'named' | 'common' | 'unusual' | 'impossible';

const NAMED: Readonly<Record<SerialMode, Readonly<Record<string, FormatStanding>>>> = {
  rtu: { '8E1': 'default', '8O1': 'named', '8N2': 'named', '8N1': 'common' },
  ascii: { '7E1': 'default', '7O1': 'named', '7N2': 'named', '8N1': 'common' },
};

/** What the specification says of a format: SL 2.5.1 for RTU, SL 2.5.2 for ASCII. */
export const formatStanding = (mode: SerialMode, format: SerialFormat): FormatStanding =>
  NAMED[mode][serialFormatName(format)] ?? (mode === 'rtu' && format.dataBits === 7 ? 'impossible' : 'unusual');
