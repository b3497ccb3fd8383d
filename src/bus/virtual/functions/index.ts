import { diagnose, eventCounter, eventLog, exceptionStatus } from './diagnosis.ts';
import { readFifo, readFile, writeFile } from './files.ts';
import type { Handler } from './handler.ts';
import { identification, serverId } from './identification.ts';
import { maskRegister, reads, readWriteRegisters, writeCoil, writeRegister, writes } from './tables.ts';

/** By function code, how a device carries it out: every public one. */
export const handlers: Readonly<Record<number, Handler>> = {
  1: reads('coil', 'bits'),
  2: reads('discrete-input', 'bits'),
  3: reads('holding-register', 'registers'),
  4: reads('input-register', 'registers'),
  5: writeCoil,
  6: writeRegister,
  7: exceptionStatus,
  8: diagnose,
  11: eventCounter,
  12: eventLog,
  15: writes('coil', 'bits'),
  16: writes('holding-register', 'registers'),
  17: serverId,
  20: readFile,
  21: writeFile,
  22: maskRegister,
  23: readWriteRegisters,
  24: readFifo,
  43: identification,
};
