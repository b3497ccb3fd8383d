import { codeFault } from './code-ranges.ts';
import { type Field, type Force, type Layout, next, type Values } from './field.ts';
import { acceptHex } from './fields/hex.ts';
import { u8 } from './fields/number.ts';
import { describeFunction } from './functions/index.ts';
import { fromHex, toHex } from './hex.ts';
import type { Section } from './problem.ts';
import type { Direction, Reading } from './reading.ts';
import { Span } from './span.ts';

/** A PDU has at most this many bytes (AP 4.1). */
export const MOST_PDU = 253;

/** Where a PDU ends by its own fields: beyond the bytes given where some are missing, before them where some are left. */
export interface PduEnd {
  readonly at: number;
  /** No byte tells where it ends; it takes all there is. */
  readonly open: boolean;
}

/**
 * Reads the PDU in `bytes[from, end)` into `reading`, field by field, by the function's description: values, spans, and
 * the problems of each field. Bytes that no field takes get no span yet; whoever knows the frame's end closes the PDU.
 */
export function readPdu(reading: Reading, bytes: Uint8Array, from: number, end: number): PduEnd {
  if (from >= end) {
    reading.force('functionCode', '');
    return { at: from + 1, open: false };
  }
  const functionCode = bytes[from] as number;
  const codeSpan = new Span('functionCode', 'function', from, from + 1);
  reading.functionCode = functionCode;
  reading.spans.push(codeSpan);
  const description = describeFunction(functionCode, reading.direction);
  reading.description = description;
  if (reading.request?.functionCode !== functionCode) reading.request = undefined;
  const fault = codeFault(reading.direction === 'response' ? functionCode & 0x7f : functionCode);
  if (fault) reading.report(fault, codeSpan);
  if (description.serialOnly && reading.transport === 'tcp') {
    reading.report({ code: 'function-serial-only', severity: 'note', functionCode }, codeSpan);
  }
  return readFields(reading, description[reading.direction], bytes, from + 1, end);
}

function readFields(reading: Reading, first: Layout, bytes: Uint8Array, from: number, end: number): PduEnd {
  let layout = first;
  let at = from;
  for (;;) {
    const { fields, section } = layout;
    for (let i = 0; i < fields.length; i++) {
      const field = fields[i] as Field;
      const size = field.width || field.size(bytes, at, end, reading);
      const stop = at + size;
      if (stop <= end) {
        const taken = field.width || field.whole(bytes, at, stop);
        readField(reading, field, bytes, at, at + taken, section);
        // Bytes of this field's own that make no whole item end the PDU's reading.
        if (taken !== size) return { at: stop, open: false };
        at = stop;
        if (field.open) return { at, open: true };
      } else {
        return { at: stop + readCut(reading, layout, i, bytes, at, end), open: false };
      }
    }
    const following = next(layout, reading.fields);
    if (following === undefined) return { at, open: false };
    layout = following;
  }
}

function readField(
  reading: Reading,
  field: Field,
  bytes: Uint8Array,
  from: number,
  to: number,
  section: Section | undefined,
): void {
  const value = field.read(bytes, from, to, reading);
  if (field.derive === undefined) reading.fields[field.name] = value;
  else reading.derived[field.name] = value;
  const span = new Span(field.name, field.kind, from, to);
  if (to > from) reading.spans.push(span);
  const rules = field.rules;
  for (let i = 0; i < rules.length; i++) {
    const fault = (rules[i] as Field['rules'][number])(value, reading);
    if (fault !== undefined) reading.report(fault, to > from ? span : (lastSpan(reading) ?? span), section);
  }
}

/** Takes what is there of field `index`, in which the bytes end; returns the least the fields after it still need. */
function readCut(reading: Reading, layout: Layout, index: number, bytes: Uint8Array, at: number, end: number): number {
  const field = layout.fields[index] as Field;
  if (field.width > 0) {
    reading.force(field.name, toHex(bytes, at, end));
    if (end > at) reading.spans.push(new Span(field.name, field.kind, at, end));
  } else {
    readField(reading, field, bytes, at, at + field.whole(bytes, at, end), layout.section);
  }
  let later = 0;
  for (const absent of layout.fields.slice(index + 1)) {
    reading.force(absent.name, '');
    later += absent.width;
  }
  // A choice after these brings its own fields only once its value is there.
  return later;
}

/**
 * Ends the PDU at `end`, which something other than its fields may have decided. Bytes that no field takes get their
 * span, and derived values that the encoder would have written otherwise become forced. `closed` says that the frame is
 * known to end here, so that missing bytes are a fault and not a matter of waiting.
 */
export function closePdu(
  reading: Reading,
  bytes: Uint8Array,
  start: number,
  pdu: PduEnd,
  end: number,
  closed: boolean,
): void {
  if (closed && pdu.at !== end) reportEnd(reading, pdu.at - end, end);
  const read = Math.max(start, lastSpan(reading)?.to ?? start);
  if (read < end) {
    const span = new Span('rest', 'rest', read, end);
    reading.spans.push(span);
    reading.force('rest', toHex(bytes, read, end));
    if (pdu.at <= end) reading.report({ code: 'pdu-rest', severity: 'error', bytes: end - read }, span);
  }
  if (end - start > MOST_PDU) {
    const span = reading.spans.find(({ to }) => to > start + MOST_PDU) as Span;
    reading.report(
      { code: 'pdu-too-long', severity: 'error', got: end - start, most: MOST_PDU, section: 'AP 4.1' },
      span,
    );
  }
  forceDerived(reading);
}

const lastSpan = ({ spans }: Reading): Span | undefined => spans[spans.length - 1];

/** Says which count contradicts the known end of the PDU, `missing` bytes before its fields end (or after, below 0). */
function reportEnd(reading: Reading, missing: number, end: number): void {
  const last = lastSpan(reading);
  if (last === undefined) return;
  const { fewer } = lastField(reading) ?? {};
  const items = reading.spans.find(({ name }) => name === fewer?.by);
  if (missing > 0 && fewer !== undefined && items !== undefined && last.to === end) {
    reading.report(fewer.fault(reading), items, 'AP 6.21');
    return;
  }
  const count = reading.spans.find(({ kind }) => kind === 'count');
  if (count !== undefined) {
    const got = reading.derived[count.name] as number;
    reading.report({ code: 'count-wrong', severity: 'error', got, expected: got - missing }, count);
  }
  if (missing > 0) reading.report({ code: 'pdu-short', severity: 'error', missing }, last);
}

/** The field read last, where the whole of the PDU is laid out. */
function lastField({ description, direction, fields }: Reading): Field | undefined {
  let layout = description?.[direction];
  let last = layout;
  while (layout) {
    last = layout;
    layout = next(layout, fields);
  }
  return last?.fields[last.fields.length - 1];
}

/** Derived values that do not follow from the fields are the frame's own: they are forced. */
function forceDerived(reading: Reading): void {
  const { description, direction, fields, derived } = reading;
  let layout = description?.[direction];
  while (layout !== undefined) {
    for (const field of layout.fields) {
      if (field.derive === undefined) continue;
      const value = derived[field.name];
      if (value !== undefined && value !== field.derive(fields)) reading.force(field.name, value as number);
    }
    layout = next(layout, fields);
  }
}

/** The bytes of a PDU in the order they will be written. A piece without a field is bytes verbatim. */
export interface PduPlan {
  readonly fields: (Field | undefined)[];
  readonly values: unknown[];
  length: number;
}

/** Works out what a PDU will be; throws a `FrameError` for what has no bytes. */
export function planPdu(
  functionCode: number | undefined,
  direction: Direction,
  fields: Values,
  force: Force | undefined,
): PduPlan {
  const plan: PduPlan = { fields: [], values: [], length: 0 };
  planField(plan, codeField, functionCode, force);
  if (functionCode !== undefined) {
    let layout: Layout | undefined = describeFunction(functionCode, direction)[direction];
    while (layout !== undefined) {
      for (const field of layout.fields) {
        planField(plan, field, field.derive === undefined ? fields[field.name] : field.derive(fields), force);
      }
      layout = next(layout, fields);
    }
  }
  const rest = force?.['rest'];
  if (rest !== undefined) planVerbatim(plan, rest, 'rest');
  return plan;
}

const codeField = u8('functionCode', { kind: 'function' });

function planField(plan: PduPlan, field: Field, value: unknown, force: Force | undefined): void {
  const forced = force?.[field.name];
  if (typeof forced === 'string') {
    planVerbatim(plan, forced, field.name);
    return;
  }
  const accepted = field.accept(forced === undefined ? value : forced, field.name);
  plan.fields.push(field);
  plan.values.push(accepted);
  plan.length += field.width || field.length(accepted);
}

function planVerbatim(plan: PduPlan, text: unknown, name: string): void {
  const bytes = fromHex(acceptHex(text, name)) as Uint8Array;
  plan.fields.push(undefined);
  plan.values.push(bytes);
  plan.length += bytes.length;
}

export function writePdu(out: Uint8Array, from: number, plan: PduPlan, force: Force | undefined): void {
  const { fields, values } = plan;
  let at = from;
  for (let i = 0; i < fields.length; i++) {
    const field = fields[i];
    const value = values[i];
    if (field === undefined) {
      out.set(value as Uint8Array, at);
      at += (value as Uint8Array).length;
    } else {
      field.write(out, at, value, force);
      at += field.width || field.length(value);
    }
  }
}
