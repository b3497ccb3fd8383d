import { firstAddress, partsOf, type Reading, type Span, type Values } from '../../modbus/index.ts';

/** A register of the frame, with its bytes. */
export interface FrameRegister {
  readonly value: number;
  readonly from: number;
  readonly to: number;
  /** Zero-based, where the frame or the request it answers tells it. */
  readonly address: number | undefined;
  /** Of a file, where the frame or the request it answers tells it (AP 6.14). */
  readonly record?: { readonly file: number; readonly record: number } | undefined;
}

/** Registers of the frame that follow each other, one list after the other. */
export function runsOf(reading: Reading, bytes: Uint8Array): FrameRegister[][] {
  return reading.spans.flatMap((span) => runsIn(reading, bytes, span)).filter((run) => run.length > 0);
}

function runsIn(reading: Reading, bytes: Uint8Array, span: Span): FrameRegister[][] {
  const { name, kind } = span;
  if (kind === 'registers') {
    const first = firstAddress(reading, name);
    return [
      partsOf(reading, bytes, span).map(({ index, span: { from, to }, values }) => ({
        value: values['value'] as number,
        from,
        to,
        address: first === undefined ? undefined : first + index,
      })),
    ];
  }
  if (kind === 'groups') {
    return partsOf(reading, bytes, span).flatMap(({ index, parts, values }) =>
      parts
        .filter((part) => part.kind === 'registers')
        .map((part) => split(part, values[part.name], recordOf(reading, index, values))),
    );
  }
  // A single value beside the address of a register is that register.
  const { value, address } = reading.fields;
  const single = name === 'value' && kind === 'number' && reading.description?.table === 'holding-register';
  if (!single || typeof value !== 'number' || typeof address !== 'number') return [];
  return [[{ value, from: span.from, to: span.to, address }]];
}

/** The record that a group begins with: its own, or that of the request's group it answers. */
function recordOf({ request }: Reading, index: number, own: Values): FrameRegister['record'] {
  const asked: unknown = request?.fields['subRequests'];
  const group: unknown = 'recordNumber' in own || !Array.isArray(asked) ? own : asked[index];
  const { fileNumber: file, recordNumber: record } = (group ?? {}) as Values;
  return typeof file === 'number' && typeof record === 'number' ? { file, record } : undefined;
}

/** The registers of a list inside a group, which have records instead of addresses. */
function split({ from, to }: Span, list: unknown, first: FrameRegister['record']): FrameRegister[] {
  if (!Array.isArray(list)) return [];
  const each = (to - from) / list.length;
  return list.map((value: number, index) => ({
    value,
    from: from + index * each,
    to: from + (index + 1) * each,
    address: undefined,
    record: first && { file: first.file, record: first.record + index },
  }));
}
