export { entityNumber } from './address.ts';
export { formatBytes } from './bytes.ts';
export { type ByteFormat, byteFormats, writeBytes } from './formats.ts';
export { type ListReading, readBits, readNumbers } from './list.ts';
export { formatBinary, formatHex, readNumber } from './number.ts';
export { readOctets } from './octets.ts';
