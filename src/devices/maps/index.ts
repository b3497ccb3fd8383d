export {
  type MapFault,
  type MapFaultCode,
  type MapNotice,
  type MapNoticeCode,
  type MapQuestion,
  mapFaultCodes,
  mapNoticeCodes,
  type QuestionCode,
  questionCodes,
} from './codes.ts';
export { type ColumnReason, columnReasons, type MapColumn, type Meaning, meanings } from './meaning.ts';
export { type MapReading, type RowFate, readMap } from './read-map.ts';
export { type RegisterMapOptions, type RegisterMapReading, readMapsOf, readRegisterMap } from './read-register-map.ts';
export { readSheets } from './read-sheets.ts';
export type { Sheet, SheetRow, SheetsReading } from './sheet.ts';
export { writeMbmap } from './write-mbmap.ts';
