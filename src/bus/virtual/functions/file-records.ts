import type { ProblemCode } from '../../../modbus/index.ts';
import { ECHO, exception, handle, ILLEGAL_DATA_VALUE, noSuchAddress, reply } from './handler.ts';

/** Reference type, file and record are addresses; what is left of the values are counts (AP 6.14, AP 6.15). */
const addressProblems: readonly ProblemCode[] = ['value-not-allowed', 'value-out-of-range'];

export const readFile = handle(
  0x14,
  ({ files }, { subRequests }) => {
    const found = subRequests.map(({ fileNumber, recordNumber, recordLength }) => {
      const end = recordNumber + recordLength;
      const file = files.get(fileNumber);
      return file === undefined || end > file.length ? undefined : Array.from(file.subarray(recordNumber, end));
    });
    const subResponses = found.flatMap((recordData) => (recordData ? [{ referenceType: 6, recordData }] : []));
    return subResponses.length < found.length ? noSuchAddress : reply({ subResponses });
  },
  { addressProblems },
);

export const writeFile = handle(
  0x15,
  ({ files }, { subRequests }) => {
    const has = ({ fileNumber, recordNumber, recordData }: (typeof subRequests)[number]) =>
      recordNumber + recordData.length <= (files.get(fileNumber)?.length ?? -1);
    if (!subRequests.every(has)) return noSuchAddress;
    for (const { fileNumber, recordNumber, recordData } of subRequests) {
      files.get(fileNumber)?.set(recordData, recordNumber);
    }
    return ECHO;
  },
  { addressProblems },
);

/** A longer queue is refused (AP 6.18). */
const MOST_VALUES = 31;
const WORD = 0xffff;

export const readFifo = handle(0x18, ({ fifos }, { fifoPointerAddress }) => {
  const fifoValues = fifos.get(fifoPointerAddress);
  if (fifoValues === undefined) return noSuchAddress;
  return fifoValues.length > MOST_VALUES
    ? exception(ILLEGAL_DATA_VALUE)
    : reply({ fifoValues: fifoValues.map((value) => value & WORD) });
});
