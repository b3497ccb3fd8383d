import ModbusRTU from 'modbus-serial';
import calculate from 'modbus-serial/utils/crc16.js';
import { registersToBuffer, toBuffer } from './buffers.mjs';

export const crc16 = { prepare: toBuffer, run: (bytes) => calculate(bytes) };

// Frames are made where they are sent and read where they arrive: the client gets a port that only keeps what is sent,
// and no time-out, so that no timer is started.
let sent;
const port = {
  isOpen: true,
  _transactionIdRead: 1,
  _transactionIdWrite: 1,
  write: (bytes) => {
    sent = bytes;
  },
};
const client = new ModbusRTU(port);

export const encode03 = {
  run: ({ unitId, startAddress, quantity }) => {
    client.writeFC3(unitId, startAddress, quantity);
    return sent;
  },
};

export const encode10 = {
  prepare: registersToBuffer,
  run: ({ unitId, startAddress, registers }) => {
    client.writeFC16(unitId, startAddress, registers);
    return sent;
  },
  note: 'given the registers as bytes, which it copies: faster than its way from numbers',
};

/** The request is noted once: what its client notes of each request is no part of reading a reply. */
const decode = (quantity) => {
  let received;
  const transaction = {
    nextAddress: 17,
    nextDataAddress: 107,
    nextCode: 3,
    nextLength: 5 + 2 * quantity,
    next: (error, result) => {
      if (error) throw error;
      received = result;
    },
  };
  return {
    prepare: (frame) => {
      client._transactions[1] = transaction;
      return toBuffer(frame);
    },
    run: (frame) => {
      client._onReceive(frame);
      return received;
    },
    registers: ({ data }) => data,
    note: 'checks CRC, length, unit and function code; no bytes explained, ends at the first fault',
  };
};

export const decode10 = decode(10);
export const decode100 = decode(100);
