// Inputs in the types of the peers that work on Node's Buffer.

export const toBuffer = (bytes) => Buffer.from(bytes);

/** The same request with its registers as bytes. */
export const registersToBuffer = (request) => ({
  ...request,
  registers: Buffer.concat(request.registers.map(twoBytes)),
});

/** The same request with each of its registers as two bytes. */
export const registersToBuffers = (request) => ({ ...request, registers: request.registers.map(twoBytes) });

const twoBytes = (register) => Buffer.of(register >>> 8, register & 0xff);
