export { LAST_ADDRESS, quantityOf, type Table, tableDigits } from './address.ts';
export { MOST_ASCII } from './ascii.ts';
export { dateText, daysFrom } from './calendar.ts';
export * from './checksum-steps/index.ts';
export { type Checksum, checksum, checksums, crcChecksum } from './checksums/checksum.ts';
export { ownCrc, residueOf } from './checksums/own-crc.ts';
export { type PolynomialForms, polynomialForms } from './checksums/polynomial.ts';
export { type CodeRange, codeFault, codeRange, vendorOf } from './code-ranges.ts';
export { crc, crcAdd, crcStart, crcValue, sum8, xor8 } from './crc.ts';
export { type CatalogueCrc, type CrcAlgorithm, type CrcName, crcCatalogue } from './crc-catalogue.ts';
export { CrcWindows } from './crc-windows.ts';
export { crc16 } from './crc16.ts';
export { type DecodeContext, decodeFrame } from './decode-frame.ts';
export { demandWhole } from './demand.ts';
export { dictionary } from './dictionary.ts';
export { encodeFrame, type FrameInput } from './encode-frame.ts';
export { type Field, type Force, fieldsOf, type Layout, type Range, type Values, type ValuesOf } from './field.ts';
export { FrameError, type FrameErrorReason } from './frame-error.ts';
export { areJudgedAlike, type FrameAt, framesAt, judgeRtu, nextPlace } from './frames-at.ts';
export type { FunctionAccess, FunctionCode, FunctionGroup } from './function-code.ts';
export {
  accessOf,
  counterpart,
  functionFor,
  functionsOf,
  mostOf,
  readerOf,
  twinOf,
  writerOf,
  writesAt,
} from './function-facts.ts';
export { meiTypes } from './functions/2b-encapsulated-interface-transport.ts';
export { diagnosticSubFunctions } from './functions/08-diagnostics.ts';
export { exceptionCodes } from './functions/exception.ts';
export { describeFunction, functionCodes, functionOf } from './functions/index.ts';
export { rawFunction } from './functions/raw.ts';
export { fromHex, hexDigit, hexDigits, sameBytes, spacedHex, toHex } from './hex.ts';
export { joinBytes } from './join-bytes.ts';
export { lrc } from './lrc.ts';
export { envelopeSection, fieldByName, firstAddress, type Part, partsOf, sectionOf } from './parts.ts';
export { MOST_PDU } from './pdu.ts';
export type { Fault, Problem, ProblemCode, ProblemData, Section, Severity } from './problem.ts';
export { type Direction, fieldValue, type Outcome, type Reading, type Transport } from './reading.ts';
export { MOST_RTU } from './rtu.ts';
export { RtuScan } from './rtu-scan.ts';
export { type FieldKind, inPairs, Span } from './span.ts';
export { MBAP, MOST_TCP } from './tcp.ts';
export * from './timing/index.ts';
export {
  againstRequest,
  BROADCAST,
  FIRST_UNIT,
  isAgainstRequest,
  isAsLongAsAsked,
  LAST_UNIT,
  TCP_DIRECT,
} from './unit-rules.ts';
export * from './values/index.ts';
export * from './wire/index.ts';
