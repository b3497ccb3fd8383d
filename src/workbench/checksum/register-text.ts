import { formatHex } from '../../notation/index.ts';

/** How many hexadecimal digits a value has, by its bits. */
export const digitsOf = (bits: number): number => Math.ceil(bits / 4);

/** A register in hexadecimal, with all its digits. */
export const registerHex = (bits: number, value: number): string => formatHex(value, digitsOf(bits));

export const byteHex = (value: number): string => formatHex(value, 2);

/** How many characters a register takes in binary, with a gap between its groups of four. */
export const binaryWidth = (bits: number): number => bits + digitsOf(bits) - 1;
