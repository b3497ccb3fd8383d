export { entityNumber } from './address.ts';
export { formatBytes } from './bytes.ts';
export { type ByteFormat, byteFormats, writeBytes } from './formats.ts';
export { type ListReading, readBits, readNumbers } from './list.ts';
export { formatBinary, formatHex, readNumber } from './number.ts';
export { readOctets } from './octets.ts';
export {
  type AlternativeReading,
  type ByteNotation,
  type ByteText,
  type Chunk,
  type ChunkLabel,
  readBytes,
  type TextProblem,
  type TextProblemCode,
  type TextRange,
} from './read-bytes/index.ts';
