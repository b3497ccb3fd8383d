import * as library from 'modbus-webserial';

const { buildReadHolding, buildWriteMultiple, parseReadHolding } = library;

export const crc16 = { run: (bytes) => library.crc16(bytes) };

export const encode03 = {
  run: ({ unitId, startAddress, quantity }) => buildReadHolding(unitId, startAddress, quantity),
};

export const encode10 = {
  run: ({ unitId, startAddress, registers }) => buildWriteMultiple(unitId, startAddress, registers),
};

export const decode10 = {
  run: (frame) => parseReadHolding(frame),
  registers: (registers) => registers,
  note: 'checks CRC and function code, not the length; no bytes explained, ends at the first fault',
};

export const decode100 = decode10;
