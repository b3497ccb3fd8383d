export { entityNumber, sixDigitNumber, zeroBasedAddress } from './address.ts';
export { plainAddress } from './address-forms.ts';
export {
  type AddressConvention,
  type AddressMeaning,
  type AddressNotation,
  addressConventions,
  addressMeant,
} from './address-meanings.ts';
export {
  type AddressPlace,
  type AddressRepair,
  type AddressTrap,
  type AddressTrapCode,
  addressTraps,
} from './address-traps.ts';
export { type BitNumbers, formatBitNumbers, readBitNumbers } from './bit-numbers.ts';
export { formatBytes } from './bytes.ts';
export { clearAddress, clearProtocolAddress } from './clear-address.ts';
export { type Duration, readDuration } from './duration.ts';
export { type FileText, fileText, readFileText, type TextEncoding } from './file-text.ts';
export { type ByteFormat, byteFormats, writeBytes } from './formats.ts';
export { type JsonFault, type JsonReading, readJson } from './json.ts';
export { type ListReading, readBits, readNumbers } from './list.ts';
export { formatBinary, formatHex, readNumber, wholeNumber } from './number.ts';
export { type TableLanguage, writeNumberTable } from './number-table.ts';
export { readOctets } from './octets.ts';
export { latinLetters, plainWords } from './plain-words.ts';
export { type PlcCode, type PlcMeaning, plcCodes, plcMeanings } from './plc-devices.ts';
export { bitOfAddress, readAddress } from './read-address.ts';
export {
  type AlternativeReading,
  type ByteNotation,
  type ByteText,
  type Chunk,
  type ChunkLabel,
  readBytes,
  type SetAside,
  type TextProblem,
  type TextProblemCode,
  type TextRange,
} from './read-bytes/index.ts';
export { type TableFormat, tableFormats, unguardedCell, writeCsvFile, writeTableText } from './table-text.ts';
export * from './values/index.ts';
export {
  printedAddress,
  type WrittenAddress,
  writeAddress,
} from './write-address.ts';
