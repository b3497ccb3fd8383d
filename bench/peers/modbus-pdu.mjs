import modbusPdu from 'modbus-pdu';
import { pduOf } from '../frames.mjs';
import { registersToBuffers, toBuffer } from './buffers.mjs';

const { ReadHoldingRegisters, WriteMultipleRegisters } = modbusPdu;

const note = 'the PDU alone: no unit identifier, no CRC';

export const encode03 = {
  run: ({ startAddress, quantity }) => ReadHoldingRegisters.Request.build(startAddress, quantity),
  pduOnly: true,
  note,
};

export const encode10 = {
  prepare: registersToBuffers,
  run: ({ startAddress, registers }) => WriteMultipleRegisters.Request.build(startAddress, registers),
  pduOnly: true,
  note: `${note}; given each register as two bytes, the only way it takes them`,
};

export const decode10 = {
  prepare: (frame) => toBuffer(pduOf(frame)),
  run: (pdu) => ReadHoldingRegisters.Response.parse(pdu),
  registers: (blocks) => blocks.map((block) => block.readUInt16BE(0)),
  note: `${note}; does not look at the function code, and leaves each register as two bytes`,
};

export const decode100 = decode10;
