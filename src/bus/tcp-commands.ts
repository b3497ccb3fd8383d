import { accessOf, functionFor, type Reading, type Table } from '../modbus/index.ts';

/** How mbpoll calls the tables. */
const MBPOLL_TYPES: ReadonlyMap<Table, string> = new Map([
  ['coil', '0'],
  ['discrete-input', '1'],
  ['input-register', '3'],
  ['holding-register', '4'],
]);

/**
 * The mbpoll command for a request over Modbus TCP; `undefined` if mbpoll cannot send it.
 * @param host the name or address of the server
 */
export function mbpollCommand(reading: Reading, host: string): string | undefined {
  const { unitId, functionCode, description, fields } = reading;
  const { table, items } = description ?? {};
  const access = accessOf(reading);
  if (table === undefined || items === undefined || items === 'other' || access === 'reads-and-writes')
    return undefined;
  // mbpoll chooses the function itself: the usual one for the table, the access and the number of items.
  if (functionFor(table, access, items)?.code !== functionCode) return undefined;
  const type = MBPOLL_TYPES.get(table);
  const address = fields['startAddress'] ?? fields['address'];
  const values = access === 'reads' ? [] : writtenValues(reading);
  if (type === undefined || typeof address !== 'number' || unitId === undefined || values === undefined)
    return undefined;
  const quantity = fields['quantity'];
  const count = values.length === 0 && typeof quantity === 'number' ? ['-c', String(quantity)] : [];
  // -0: addresses count from 0, as in the frame. A single value written by 0F or 10 needs -W.
  const several = access === 'writes' && items === 'many' ? ['-W'] : [];
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

/** The values that a request writes; `undefined` if mbpoll does not send such a value. */
function writtenValues({ fields, forced }: Reading): readonly number[] | undefined {
  const { value, registers, bits } = fields;
  const list = registers ?? bits;
  if (Array.isArray(list)) return list.map(Number);
  // Of a coil, mbpoll sends ON and OFF only.
  return value === undefined || forced['rawValue'] !== undefined ? undefined : [Number(value)];
}

/** Shell commands that send the frame unchanged with nc and print what comes back. */
export function ncCommand(bytes: Uint8Array, host: string, port: number): string {
  const escaped = Array.from(bytes, (byte) => `\\${byte.toString(8).padStart(3, '0')}`).join('');
  return `printf '${escaped}' | nc -w 2 ${host} ${port} | xxd`;
}
