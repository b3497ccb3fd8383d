import { codeFault } from './code-ranges.ts';
import { type Field, type Force, fieldsOf, type Layout, next, outOfRange, type Values } from './field.ts';
import { u8 } from './fields/number.ts';
import { describeFunction } from './functions/index.ts';
import { toHex } from './hex.ts';
import type { Output } from './output.ts';
import type { Section } from './problem.ts';
import type { Direction, Reading } from './reading.ts';
import { Span } from './span.ts';

/** A PDU has at most this many bytes (AP 4.1). */
export const MOST_PDU = 253;

/**
 * Reads the PDU in `bytes[from, end)` into `reading`, field by field, by the function's description: values, spans, and the
 * problems of each field. Bytes that no field takes get no span yet; whoever knows the frame's end closes the PDU. Answers
 * where the PDU ends by its own fields: beyond `end` if bytes are missing, before it if some are left.
 */
export function readPdu(reading: Reading, bytes: Uint8Array, from: number, end: number): number {
  if (from >= end) {
    reading.force('functionCode', '');
    return from + 1;
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

function readFields(reading: Reading, first: Layout, bytes: Uint8Array, from: number, end: number): number {
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
        if (taken !== size) return stop;
        at = stop;
        if (field.open) reading.open = true;
      } else {
        return stop + readCut(reading, layout, i, bytes, at, end);
      }
    }
    const following = next(layout, reading.fields);
    if (following === undefined) return at;
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
  const value = field.plain
    ? to - from === 1
      ? bytes[from]
      : ((bytes[from] as number) << 8) | (bytes[from + 1] as number)
    : field.read(bytes, from, to, reading);
  if (field.derive === undefined) reading.fields[field.name] = value;
  else if (field.kind === 'count') reading.count = value as number;
  else reading.items = value as number;
  const span = new Span(field.name, field.kind, from, to);
  if (to > from) reading.spans.push(span);
  const at = to > from ? span : (lastSpan(reading) ?? span);
  if (field.range !== undefined) {
    const fault = outOfRange(field, value);
    if (fault !== undefined) reading.report(fault, at, section);
  }
  if (field.rules.length > 0) applyRules(reading, field.rules, value, at, section);
  if (reading.request !== undefined) applyRules(reading, field.replyRules, value, at, section);
}

function applyRules(
  reading: Reading,
  rules: Field['rules'],
  value: unknown,
  span: Span,
  section: Section | undefined,
): void {
  for (let i = 0; i < rules.length; i++) {
    const fault = (rules[i] as Field['rules'][number])(value, reading);
    if (fault !== undefined) reading.report(fault, span, section);
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
    later += absent.width || absent.size(bytes, end, end, reading);
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
  pduEnd: number,
  end: number,
  closed: boolean,
): void {
  if (closed && pduEnd !== end) reportEnd(reading, pduEnd - end, end);
  const read = Math.max(start, lastSpan(reading)?.to ?? start);
  if (read < end) {
    const span = new Span('rest', 'rest', read, end);
    reading.spans.push(span);
    reading.force('rest', toHex(bytes, read, end));
    if (pduEnd <= end) reading.report({ code: 'pdu-rest', severity: 'error', bytes: end - read }, span);
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
    const got = reading.count;
    reading.report({ code: 'count-wrong', severity: 'error', got, expected: got - missing }, count);
  }
  if (missing > 0) reading.report({ code: 'pdu-short', severity: 'error', missing }, last);
}

/** The last field of the PDU's layout, through its choices. */
function lastField({ description, direction, fields }: Reading): Field | undefined {
  let last: Field | undefined;
  for (const { field } of fieldsOf(description, direction, fields)) last = field;
  return last;
}

/** Derived values that do not follow from the fields are the frame's own: they are forced. */
function forceDerived(reading: Reading): void {
  const { description, direction, fields } = reading;
  let layout = description?.[direction];
  while (layout !== undefined) {
    for (let i = 0; i < layout.derived.length; i++) {
      const field = layout.derived[i] as Field;
      const value = field.kind === 'count' ? reading.count : reading.items;
      // A field that is cut off is forced already, to the bytes that are there.
      if (value !== field.derive?.(fields) && !Object.hasOwn(reading.forced, field.name))
        reading.force(field.name, value);
    }
    layout = next(layout, fields);
  }
}

/**
 * Appends the PDU of these fields to `out`; throws a `FrameError` for what has no bytes. Derived fields that are not forced
 * are worked out.
 */
export function writePdu(
  out: Output,
  functionCode: number | undefined,
  direction: Direction,
  fields: Values,
  force: Force | undefined,
): void {
  writeField(out, codeField, functionCode, force);
  let layout = functionCode === undefined ? undefined : describeFunction(functionCode, direction)[direction];
  while (layout !== undefined) {
    const list = layout.fields;
    for (let i = 0; i < list.length; i++) {
      const field = list[i] as Field;
      if (field.derive === undefined) {
        writeField(out, field, fields[field.name], force);
      } else {
        const value = field.derive(fields);
        if (value === undefined && force?.[field.name] === undefined) refuse(layout, fields, force);
        writeField(out, field, value, force);
      }
    }
    layout = next(layout, fields);
  }
  if (force?.['rest'] !== undefined) out.pairs(force['rest'], 'rest');
}

/** Throws for the field because of which another cannot be derived. */
function refuse(layout: Layout, fields: Values, force: Force | undefined): void {
  for (const field of layout.fields) {
    if (field.derive === undefined && force?.[field.name] === undefined) field.accept(fields[field.name], field.name);
  }
}

const codeField = u8('functionCode', { kind: 'function' });

function writeField(out: Output, field: Field, value: unknown, force: Force | undefined): void {
  const forced = force === undefined ? undefined : force[field.name];
  if (typeof forced === 'string') {
    out.pairs(forced, field.name);
    return;
  }
  const accepted = field.accept(forced === undefined ? value : forced, field.name);
  const size = field.width || field.length(accepted);
  const at = out.grow(size);
  field.write(out.bytes, at, accepted, force);
}
