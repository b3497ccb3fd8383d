import type { Reading } from '../modbus/index.ts';

/** The kinds of data that mbpoll knows, by function code. */
const MBPOLL_TYPES: Readonly<Record<number, string>> = {
  1: '0',
  2: '1',
  3: '4',
  4: '3',
  5: '0',
  6: '4',
  15: '0',
  16: '4',
};

/**
 * The command of mbpoll that does what a request over Modbus TCP asks for; `undefined` where mbpoll cannot.
 * @param host the name or address of the server
 */
export function mbpollCommand(reading: Reading, host: string): string | undefined {
  const { unitId, functionCode, fields } = reading;
  const type = functionCode === undefined ? undefined : MBPOLL_TYPES[functionCode];
  const address = fields['startAddress'] ?? fields['address'];
  if (type === undefined || typeof address !== 'number' || unitId === undefined) return undefined;
  const values = valuesOf(reading);
  if (values === undefined) return undefined;
  const quantity = fields['quantity'];
  const count = values.length === 0 && typeof quantity === 'number' ? ['-c', String(quantity)] : [];
  // -0: addresses count from 0, as in the frame. A single value written by 0F or 10 needs -W.
  const several = functionCode === 15 || functionCode === 16 ? ['-W'] : [];
  const options = [
    '-m',
    'tcp',
    '-0',
    '-1',
    '-a',
    String(unitId),
    '-t',
    type,
    '-r',
    String(address),
    ...count,
    ...several,
  ];
  return ['mbpoll', ...options, host, ...(values.length > 0 ? ['--', ...values.map(String)] : [])].join(' ');
}

/** The values that a write writes; none for a read, and `undefined` where they cannot be said. */
function valuesOf({ functionCode, fields, forced }: Reading): readonly number[] | undefined {
  const { value, registers, bits } = fields;
  switch (functionCode) {
    case 5:
      // Anything but ON and OFF is a value that mbpoll does not send.
      return typeof value === 'boolean' && forced['rawValue'] === undefined ? [Number(value)] : undefined;
    case 6:
      return typeof value === 'number' ? [value] : undefined;
    case 15:
      return Array.isArray(bits) ? bits.map(Number) : undefined;
    case 16:
      return Array.isArray(registers) ? registers : undefined;
    default:
      return [];
  }
}

/** The commands of a shell that send the frame as it is with nc, and print what comes back. */
export function ncCommand(bytes: Uint8Array, host: string, port: number): string {
  const escaped = Array.from(bytes, (byte) => `\\${byte.toString(8).padStart(3, '0')}`).join('');
  return `printf '${escaped}' | nc -w 2 ${host} ${port} | xxd`;
}
