import { diagnose, eventCounter, eventLog, exceptionStatus } from './diagnosis.ts';
import { readFifo, readFile, writeFile } from './file-records.ts';
import type { Handler } from './handler.ts';
import { identification, serverId } from './identification.ts';
import {
  maskRegister,
  reads,
  readWriteRegisters,
  writeCoil,
  writeCoils,
  writeRegister,
  writeRegisters,
} from './tables.ts';

const all: readonly Handler[] = [
  reads(0x01),
  reads(0x02),
  reads(0x03),
  reads(0x04),
  writeCoil,
  writeRegister,
  exceptionStatus,
  diagnose,
  eventCounter,
  eventLog,
  writeCoils,
  writeRegisters,
  serverId,
  readFile,
  writeFile,
  maskRegister,
  readWriteRegisters,
  readFifo,
  identification,
];

/** By function code, how a device carries it out. A function that is not here is refused with 01. */
export const handlers: Readonly<Record<number, Handler>> = Object.fromEntries(
  all.map((handler) => [handler.code, handler]),
);
