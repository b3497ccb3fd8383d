/** CRC-16/MODBUS bit by bit, as SL 6.2 draws it: a second opinion on the tables of the code under test. */
export function bitwiseCrc(bytes: Iterable<number>): number {
  let register = 0xffff;
  for (const byte of bytes) {
    register ^= byte;
    for (let shift = 0; shift < 8; shift++) {
      const carry = register & 1;
      register >>= 1;
      if (carry === 1) register ^= 0xa001;
    }
  }
  return register;
}

/** The LRC as the byte that brings the sum of all to zero (SL 2.5.2.2). */
export function summedLrc(bytes: Iterable<number>): number {
  let sum = 0;
  for (const byte of bytes) sum += byte;
  return (256 - (sum % 256)) % 256;
}

/** Frames put together by the text of the specification, not by the encoder under test. */
export const asRtu = (unit: number, pdu: readonly number[]): Uint8Array => {
  const crc = bitwiseCrc([unit, ...pdu]);
  return Uint8Array.from([unit, ...pdu, crc & 0xff, crc >> 8]);
};

export const asAscii = (unit: number, pdu: readonly number[]): Uint8Array => {
  const pairs = [unit, ...pdu, summedLrc([unit, ...pdu])].map((byte) => byte.toString(16).padStart(2, '0'));
  return Uint8Array.from(`:${pairs.join('').toUpperCase()}\r\n`, (one) => one.charCodeAt(0));
};

export const asTcp = (unit: number, pdu: readonly number[], transaction = 1): Uint8Array => {
  const length = pdu.length + 1;
  return Uint8Array.from([transaction >> 8, transaction & 0xff, 0, 0, length >> 8, length & 0xff, unit, ...pdu]);
};
