// A serial line as its receiver sees it: what becomes of bytes when speed, parity or polarity are not the sender's.

/** Bits on the line for these bytes: start, eight data bits, the lowest first, and stop. */
function bitsOf(bytes) {
  const bits = [1, 1, 1];
  for (const byte of bytes) {
    bits.push(0);
    for (let i = 0; i < 8; i++) bits.push((byte >> i) & 1);
    bits.push(1);
  }
  return [...bits, ...new Array(24).fill(1)];
}

/** What a UART without parity reads that runs `rate` times as fast; each character begins at a falling edge. */
function receive(bits, rate) {
  const width = 1 / rate;
  const bytes = [];
  let at = 1;
  while (at < bits.length) {
    if (!(bits[at - 1] === 1 && bits[at] === 0)) {
      at++;
      continue;
    }
    const sample = (index) => bits[Math.floor(at + (index + 0.5) * width)] ?? bits[bits.length - 1];
    let byte = 0;
    for (let i = 0; i < 8; i++) byte |= sample(i + 1) << i;
    bytes.push(byte);
    at = Math.max(at + 1, Math.floor(at + 9.5 * width));
  }
  return Uint8Array.from(bytes);
}

export const atSpeed = (bytes, rate) => receive(bitsOf(bytes), rate);
export const inverted = (bytes) =>
  receive(
    bitsOf(bytes).map((bit) => 1 - bit),
    1,
  );
/** Seven data bits and even parity, read as eight data bits. */
export const withParityBit = (bytes) =>
  bytes.map((byte) => {
    let ones = 0;
    for (let i = 0; i < 7; i++) ones += (byte >> i) & 1;
    return (byte & 0x7f) | ((ones & 1) << 7);
  });
