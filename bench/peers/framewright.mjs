import * as library from '../../dist/lib/framewright.js';

const { decodeFrame, encodeFrame } = library;

export const crc16 = { run: (bytes) => library.crc16(bytes) };

// The description of the frame is made anew for each call, as a program would.
export const encode03 = {
  run: ({ unitId, startAddress, quantity }) =>
    encodeFrame({
      transport: 'rtu',
      direction: 'request',
      unitId,
      functionCode: 0x03,
      fields: { startAddress, quantity },
    }),
};

export const encode10 = {
  run: ({ unitId, startAddress, registers }) =>
    encodeFrame({
      transport: 'rtu',
      direction: 'request',
      unitId,
      functionCode: 0x10,
      fields: { startAddress, registers },
    }),
};

export const decode10 = {
  run: (frame) => decodeFrame(frame, { transport: 'rtu', direction: 'response' }),
  registers: ({ outcome, problems, spans, fields }) => {
    if (outcome.kind !== 'whole' || problems.length > 0 || spans.length === 0) throw new Error('not read as whole');
    return fields.registers;
  },
  note: 'checks the CRC and every rule, and says of each byte which field it belongs to',
};

export const decode100 = decode10;
