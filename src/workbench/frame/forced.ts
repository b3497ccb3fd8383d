import { describeFunction, functionCodes, type Layout } from '../../modbus/index.ts';

/** Names whose forced value is bytes and nothing else. */
export const forcedBytes: ReadonlySet<string> = new Set(['rest', 'after', 'start', 'characters', 'end']);

/** Of the envelope, and parts of fields that the encoder works out. */
const OTHERS = ['transactionId', 'protocolId', 'length', 'unitId', 'functionCode', 'checksum', 'padding', 'rawValue'];

const known = new Set<string>();

/** Whether a frame can be forced to have another value of this name: of the envelope, or of a field of any function. */
export function canForce(name: string): boolean {
  if (known.size === 0) {
    for (const other of [...forcedBytes, ...OTHERS]) known.add(other);
    const raw = describeFunction(0x41, 'request');
    const exception = describeFunction(0x81, 'response');
    for (const { request, response } of [...functionCodes, raw, exception]) addFields(request, response);
  }
  return known.has(name);
}

function addFields(...layouts: readonly Layout[]): void {
  for (const { fields, then } of layouts) {
    for (const field of fields) known.add(field.name);
    if (then) addFields(...Object.values(then.cases), then.otherwise);
  }
}
