import type { Section } from '../../modbus/index.ts';
import type { ReferenceFrame } from './reference-frame.ts';

/** A question that the specification leaves open, or answers in two ways. */
export type OpenPoint =
  | 'coilValue'
  | 'padding'
  | 'queryData'
  | 'listenOnly'
  | 'readFileLengths'
  | 'writeFileLength'
  | 'fifo'
  | 'objectCount'
  | 'canopen'
  | 'serverId'
  | 'exceptionOrder'
  | 'tcpUnit'
  | 'lrc'
  | 'silence'
  | 'oldLimits'
  | 'mask'
  | 'writeThenRead'
  | 'programFunctions'
  | 'reservedSubFunctions'
  | 'lowerCase';

/** The open points: where they stand, and frames in which the question comes up, where one can be shown. */
export const openPoints: Readonly<
  Record<OpenPoint, { readonly sections: readonly Section[]; readonly frame?: ReferenceFrame }>
> = {
  coilValue: { sections: ['AP 6.5'], frame: { texts: { functionCode: 5 }, force: { rawValue: '1' } } },
  padding: { sections: ['AP 6.11'], frame: { texts: { functionCode: 15, bits: '1 0 1' }, force: { padding: '1' } } },
  queryData: {
    sections: ['AP 6.8', 'AP 6.8.1'],
    frame: { texts: { functionCode: 8, subFunction: 0, data: '12 34 56 78' } },
  },
  listenOnly: { sections: ['AP 6.8.1'], frame: { texts: { functionCode: 8, subFunction: 4 } } },
  readFileLengths: {
    sections: ['AP 6.14'],
    frame: { kind: 'reply', texts: { functionCode: 20, 'subResponses[0].recordData': '1' } },
  },
  writeFileLength: { sections: ['AP 6.15'], frame: { texts: { functionCode: 21 } } },
  fifo: { sections: ['AP 6.18'], frame: { texts: { functionCode: 24, fifoPointerAddress: '0x04DE' } } },
  objectCount: {
    sections: ['AP 6.21'],
    frame: { kind: 'reply', texts: { functionCode: 43, meiType: 14 }, force: { numberOfObjects: '3' } },
  },
  canopen: { sections: ['AP 6.20', 'AP Annex B'], frame: { texts: { functionCode: 43, meiType: 13 } } },
  serverId: {
    sections: ['AP 6.13', 'PI function 17'],
    frame: { kind: 'reply', texts: { functionCode: 17, data: '01 FF 41 42' } },
  },
  exceptionOrder: { sections: ['AP 4.5', 'AP 6'] },
  tcpUnit: { sections: ['TG 4.4.1.2'], frame: { transport: 'tcp', texts: { unitId: 0, functionCode: 3 } } },
  lrc: {
    sections: ['SL 2.5.2.2', 'PI App. C'],
    frame: { transport: 'ascii', texts: { unitId: 10, functionCode: 1, startAddress: '0x04A1' } },
  },
  silence: { sections: ['SL 2.5.1', 'SL 2.5.1.1'] },
  oldLimits: {
    sections: ['PI App. B', 'AP 6.11', 'AP 6.12'],
    frame: { texts: { functionCode: 16, registers: '0 '.repeat(101).trim() } },
  },
  mask: {
    sections: ['AP 6.16', 'PI function 22'],
    frame: { texts: { functionCode: 22, andMask: '0x00F2', orMask: '0x0025' } },
  },
  writeThenRead: { sections: ['AP 6.17'], frame: { texts: { functionCode: 23 } } },
  programFunctions: { sections: ['PI App. A', 'AP Annex A'], frame: { texts: { functionCode: 13 } } },
  reservedSubFunctions: {
    sections: ['PI function 08', 'AP Annex A'],
    frame: { texts: { functionCode: 8, subFunction: '0x13' } },
  },
  lowerCase: { sections: ['SL 2.5.2'] },
};
