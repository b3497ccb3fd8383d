export { type Exchange, type ExchangeTimes, exchangeTimes, type Polling, pollingTime } from './exchange.ts';
export {
  bitsPerCharacter,
  type FormatStanding,
  formatStanding,
  type Parity,
  parities,
  readSerialFormat,
  type SerialFormat,
  type SerialLine,
  type SerialMode,
  serialFormatName,
  serialFormats,
} from './serial-format.ts';
export {
  ASCII_SILENCE,
  asciiGapEffect,
  bitsTime,
  charactersTime,
  countedSilences,
  fixedSilences,
  type GapEffect,
  hasFixedSilences,
  LAST_COUNTED_BAUD,
  RTU_CHARACTER_BITS,
  rtuGapEffect,
  rtuSilences,
  type Silences,
} from './silences.ts';
