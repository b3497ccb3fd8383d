export { readBytes } from './read-bytes.ts';
export type {
  AlternativeReading,
  ByteNotation,
  ByteText,
  Chunk,
  ChunkLabel,
  SetAside,
  TextProblem,
  TextProblemCode,
  TextRange,
} from './types.ts';
