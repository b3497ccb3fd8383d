import { spacedHex, toHex } from '../modbus/index.ts';

/** Bytes as upper-case hexadecimal pairs with a blank between: `06 06 02 AB`. */
export const formatBytes = (bytes: Uint8Array): string => spacedHex(toHex(bytes));
