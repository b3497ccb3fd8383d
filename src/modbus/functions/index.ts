import type { FunctionCode } from '../function-code.ts';
import { getCommEventCounter } from './0b-get-comm-event-counter.ts';
import { getCommEventLog } from './0c-get-comm-event-log.ts';
import { writeMultipleCoils } from './0f-write-multiple-coils.ts';
import { encapsulatedInterfaceTransport } from './2b-encapsulated-interface-transport.ts';
import { readCoils } from './01-read-coils.ts';
import { readDiscreteInputs } from './02-read-discrete-inputs.ts';
import { readHoldingRegisters } from './03-read-holding-registers.ts';
import { readInputRegisters } from './04-read-input-registers.ts';
import { writeSingleCoil } from './05-write-single-coil.ts';
import { writeSingleRegister } from './06-write-single-register.ts';
import { readExceptionStatus } from './07-read-exception-status.ts';
import { diagnostics } from './08-diagnostics.ts';
import { writeMultipleRegisters } from './10-write-multiple-registers.ts';
import { reportServerId } from './11-report-server-id.ts';
import { readFileRecord } from './14-read-file-record.ts';
import { writeFileRecord } from './15-write-file-record.ts';
import { maskWriteRegister } from './16-mask-write-register.ts';
import { readWriteMultipleRegisters } from './17-read-write-multiple-registers.ts';
import { readFifoQueue } from './18-read-fifo-queue.ts';
import { exception } from './exception.ts';
import { rawFunction } from './raw.ts';

/** Every public function code, in order (AP 5.1). */
export const functionCodes = [
  readCoils,
  readDiscreteInputs,
  readHoldingRegisters,
  readInputRegisters,
  writeSingleCoil,
  writeSingleRegister,
  readExceptionStatus,
  diagnostics,
  getCommEventCounter,
  getCommEventLog,
  writeMultipleCoils,
  writeMultipleRegisters,
  reportServerId,
  readFileRecord,
  writeFileRecord,
  maskWriteRegister,
  readWriteMultipleRegisters,
  readFifoQueue,
  encapsulatedInterfaceTransport,
] as const;

type Described = (typeof functionCodes)[number];

/** The description of a public function, with the types of its fields. */
export const functionOf = <C extends Described['code']>(code: C): Extract<Described, { readonly code: C }> =>
  byCode[code] as Extract<Described, { readonly code: C }>;

const byCode: readonly FunctionCode[] = Array.from(
  { length: 256 },
  (_, code) => functionCodes.find((description) => description.code === code) ?? rawFunction,
);

/** The description by which a frame with this function code is laid out: its own, the exception's, or raw data. */
export function describeFunction(functionCode: number, direction: 'request' | 'response'): FunctionCode {
  return functionCode >= 0x80 && direction === 'response' ? exception : (byCode[functionCode] ?? rawFunction);
}
