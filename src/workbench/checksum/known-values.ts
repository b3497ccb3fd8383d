/** Where known values are printed. */
export type KnownSource = 'specification' | 'guide' | 'catalogue' | 'introduction' | 'calculator' | 'published';

/** A value that a source prints: a number, or bytes in the order of sending. */
export interface Printed {
  /** What it is over, in hexadecimal; or a text, whose characters are meant. */
  readonly bytes: string;
  readonly algorithm: string;
  readonly printed: string;
  readonly as: 'number' | 'wire';
}

const CALCULATED = '21 03 03 E7 00 04';
const DIGITS = '31 32 33 34 35 36 37 38 39';

/** What specifications, catalogues and calculators print, besides the frames of the examples. Not all of it is right. */
export const knownValues: Readonly<Record<KnownSource, readonly Printed[]>> = {
  specification: [
    { bytes: '02 07', algorithm: 'CRC-16/MODBUS', printed: '41 12', as: 'wire' },
    { bytes: '02 07', algorithm: 'CRC-16/MODBUS', printed: '0x4112', as: 'number' },
  ],
  guide: [{ bytes: '0A 01 04 A1 00 01', algorithm: 'LRC', printed: '0x4F', as: 'number' }],
  catalogue: [
    { bytes: DIGITS, algorithm: 'CRC-16/MODBUS', printed: '0x4B37', as: 'number' },
    { bytes: DIGITS, algorithm: 'LRC', printed: '0x23', as: 'number' },
    { bytes: DIGITS, algorithm: 'CRC-16/KERMIT', printed: '0x2189', as: 'number' },
    { bytes: DIGITS, algorithm: 'CRC-32/ISO-HDLC', printed: '0xCBF43926', as: 'number' },
  ],
  introduction: [
    { bytes: CALCULATED, algorithm: 'CRC-16/MODBUS', printed: 'F3 1A', as: 'wire' },
    { bytes: '21 03 08 30 39 D4 31 1A 0A 22 B8', algorithm: 'CRC-16/MODBUS', printed: '0x18C4', as: 'number' },
  ],
  calculator: [
    { bytes: CALCULATED, algorithm: 'SUM-8', printed: '18', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-16/ARC', printed: '0x01F3', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-16/MODBUS', printed: '0x1AF3', as: 'number' },
    { bytes: CALCULATED, algorithm: 'Sick', printed: '0x9ACD', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-16/XMODEM', printed: '0x6083', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-16/IBM-3740', printed: '0x6E93', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-16/SPI-FUJITSU', printed: '0x51BD', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-16/KERMIT', printed: '0xCA7A', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-16/DNP', printed: '0xC278', as: 'number' },
    { bytes: CALCULATED, algorithm: 'CRC-32/ISO-HDLC', printed: '0x83E7A032', as: 'number' },
    // The characters "Lammert".
    { bytes: '4C 61 6D 6D 65 72 74', algorithm: 'SUM-8', printed: '210', as: 'number' },
  ],
  published: [
    { bytes: '11 03 06 AE 41 56 52 43 40', algorithm: 'CRC-16/MODBUS', printed: '49 AD', as: 'wire' },
    { bytes: '01 04 02 FF FF', algorithm: 'CRC-16/MODBUS', printed: 'B8 80', as: 'wire' },
  ],
};
