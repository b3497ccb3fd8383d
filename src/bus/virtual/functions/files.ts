import type { ProblemCode } from '../../../modbus/index.ts';
import { ECHO, exception, type Handler, ILLEGAL_DATA_VALUE, noSuchAddress, reply } from './handler.ts';

interface Group {
  readonly fileNumber: number;
  readonly recordNumber: number;
  readonly recordLength: number;
  readonly recordData: readonly number[];
}

/** Reference type, file and record are addresses; what is left of the values are counts (AP 6.14, AP 6.15). */
const addressProblems: readonly ProblemCode[] = ['value-not-allowed', 'value-out-of-range'];

const groupsOf = (fields: Readonly<Record<string, unknown>>) => fields['subRequests'] as readonly Group[];

/** 14 */
export const readFile: Handler = {
  addressProblems,
  perform({ files }, { fields }) {
    const found = groupsOf(fields).map(({ fileNumber, recordNumber, recordLength }) => {
      const end = recordNumber + recordLength;
      const file = files.get(fileNumber);
      return file === undefined || end > file.length ? undefined : Array.from(file.subarray(recordNumber, end));
    });
    const subResponses = found.flatMap((recordData) => (recordData ? [{ referenceType: 6, recordData }] : []));
    return subResponses.length < found.length ? noSuchAddress : reply({ subResponses });
  },
};

/** 15 */
export const writeFile: Handler = {
  addressProblems,
  perform({ files }, { fields }) {
    const groups = groupsOf(fields);
    const has = ({ fileNumber, recordNumber, recordData }: Group) =>
      recordNumber + recordData.length <= (files.get(fileNumber)?.length ?? -1);
    if (!groups.every(has)) return noSuchAddress;
    for (const { fileNumber, recordNumber, recordData } of groups) files.get(fileNumber)?.set(recordData, recordNumber);
    return ECHO;
  },
};

/** A longer queue is refused (AP 6.18). */
const MOST_VALUES = 31;
const WORD = 0xffff;

/** 18 */
export const readFifo: Handler = {
  perform({ fifos }, { fields }) {
    const fifoValues = fifos.get(fields['fifoPointerAddress'] as number);
    if (fifoValues === undefined) return noSuchAddress;
    return fifoValues.length > MOST_VALUES
      ? exception(ILLEGAL_DATA_VALUE)
      : reply({ fifoValues: fifoValues.map((value) => value & WORD) });
  },
};
