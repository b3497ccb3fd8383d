import { type Field, fieldsOf, fromHex, type Reading } from '../../modbus/index.ts';
import { formatBytes, formatHex } from '../../notation/index.ts';
import type { Draft, FrameKind } from './draft.ts';
import { forcedBytes } from './forced.ts';

const EXCEPTION = 0x80;

/**
 * The draft whose frame has exactly the bytes of a reading: what follows from other values is left to the encoder, and what
 * does not is forced.
 */
export function draftOf(reading: Reading, request: Uint8Array | undefined): Draft {
  const { transport, direction, functionCode = 0, unitId, transactionId } = reading;
  const kind: FrameKind = direction === 'request' ? 'request' : functionCode >= EXCEPTION ? 'exception' : 'reply';
  const texts: Record<string, string> = {
    functionCode: String(kind === 'exception' ? functionCode - EXCEPTION : functionCode),
  };
  if (unitId !== undefined) texts['unitId'] = String(unitId);
  if (transactionId !== undefined) texts['transactionId'] = String(transactionId);
  for (const { field } of fieldsOf(reading.description, direction, reading.fields)) {
    if (!field.derive) putText(texts, field.name, field, reading.fields[field.name]);
  }
  const force = Object.fromEntries(
    Object.entries(reading.forced).map(([name, value]) => [name, forcedText(name, value)]),
  );
  return { transport, kind, texts, force, answering: request ? formatBytes(request) : '' };
}

function putText(texts: Record<string, string>, path: string, field: Field, value: unknown): void {
  if (value === undefined) return;
  if (field.group === undefined) {
    texts[path] = textOf(field, value);
    return;
  }
  const groups = value as readonly Readonly<Record<string, unknown>>[];
  texts[path] = String(groups.length);
  groups.forEach((group, index) => {
    for (const inner of field.group ?? []) {
      if (!inner.derive) putText(texts, `${path}[${index}].${inner.name}`, inner, group[inner.name]);
    }
  });
}

function textOf({ kind, width }: Field, value: unknown): string {
  if (Array.isArray(value)) return value.join(' ');
  if (typeof value === 'boolean') return value ? '1' : '0';
  if (typeof value === 'string') return formatBytes(fromHex(value) ?? new Uint8Array());
  return kind === 'address' ? formatHex(value as number, 2 * width) : String(value);
}

function forcedText(name: string, value: number | string): string {
  if (typeof value === 'number') return name === 'checksum' ? formatHex(value, 4) : String(value);
  const pairs = formatBytes(fromHex(value) ?? new Uint8Array());
  return forcedBytes.has(name) ? pairs : `[${pairs}]`;
}
