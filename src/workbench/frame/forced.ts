import { describeFunction, functionCodes, type Layout } from '../../modbus/index.ts';

/** Names whose forced value is bytes and nothing else. */
export const forcedBytes: ReadonlySet<string> = new Set(['rest', 'after', 'start', 'characters', 'end']);

/** Numbers of the envelope that are typed, and the function code. */
const ENVELOPE = ['transactionId', 'unitId', 'functionCode'];

/** Of the envelope, and parts of fields that the encoder works out. */
const OTHERS = [...ENVELOPE, 'protocolId', 'length', 'checksum', 'padding', 'rawValue'];

const fieldNames = new Set<string>();

/** Whether a frame can be forced to have another value of this name: of the envelope, or of a field of any function. */
export const canForce = (name: string): boolean =>
  forcedBytes.has(name) || OTHERS.includes(name) || allFieldNames().has(name);

/** Whether a text of a draft can be at this path: `unitId`, `registers`, `subRequests[0].fileNumber`. */
export function isFieldPath(path: string): boolean {
  const [, name = '', inner] = /^([a-z]\w*)(?:\[\d+\]\.([a-z]\w*))?$/i.exec(path) ?? [];
  const names = allFieldNames();
  return (ENVELOPE.includes(name) || names.has(name)) && (inner === undefined || names.has(inner));
}

function allFieldNames(): ReadonlySet<string> {
  if (fieldNames.size === 0) {
    const raw = describeFunction(0x41, 'request');
    const exception = describeFunction(0x81, 'response');
    for (const { request, response } of [...functionCodes, raw, exception]) addFields(request, response);
  }
  return fieldNames;
}

function addFields(...layouts: readonly Layout[]): void {
  for (const { fields, then } of layouts) {
    for (const { name, group } of fields) {
      fieldNames.add(name);
      for (const inner of group ?? []) fieldNames.add(inner.name);
    }
    if (then) addFields(...Object.values(then.cases), then.otherwise);
  }
}
