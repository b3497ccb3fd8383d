import { dictionary } from './dictionary.ts';
import { type Field, fieldsOf } from './field.ts';
import { readGroups } from './fields/groups.ts';
import { fromHex } from './hex.ts';
import type { Section } from './problem.ts';
import type { Reading, Transport } from './reading.ts';
import { Span } from './span.ts';

/** One item of a list field: a register, a byte of coils, a group of fields. */
export interface Part {
  readonly index: number;
  readonly span: Span;
  /** The fields of a group; empty for other items. */
  readonly parts: readonly Span[];
  /** The value of the item, or of each field of a group by its span's name. */
  readonly values: Readonly<Record<string, unknown>>;
}

/** The field of the reading's description by this name, through the choices its values make. */
export function fieldByName({ description, direction, fields }: Reading, name: string): Field | undefined {
  for (const { field } of fieldsOf(description, direction, fields)) if (field.name === name) return field;
  return undefined;
}

/**
 * The items of a list field, in order, with their places in the frame. Computed on demand, because only a view needs them.
 * Empty for a field that is not a list, and for characters of an ASCII frame that are not two digits a byte.
 */
export function partsOf(reading: Reading, bytes: Uint8Array, span: Span): Part[] {
  const field = fieldByName(reading, span.name);
  const each = reading.transport === 'ascii' ? 2 : 1;
  const binary = each === 1 ? bytes.subarray(span.from, span.to) : readCharacters(bytes, span);
  if (field === undefined || binary === undefined) return [];
  const place = ({ name, kind, from, to }: Span) =>
    new Span(name, kind, span.from + each * from, span.from + each * to);
  if (field.group) {
    return readGroups(field.group, binary, 0, binary.length).map((group, index) => ({
      index,
      span: place(new Span(span.name, span.kind, group.from, group.to)),
      parts: group.spans.map(place),
      values: { ...group.derived, ...group.fields },
    }));
  }
  const list = reading.fields[span.name];
  const width = WIDTHS[field.kind];
  if (width === undefined || !Array.isArray(list)) return [];
  return Array.from({ length: binary.length / width }, (_, index) => ({
    index,
    span: place(new Span(span.name, span.kind, index * width, (index + 1) * width)),
    parts: [],
    values: { value: field.kind === 'bits' ? list.slice(8 * index, 8 * index + 8) : list[index] },
  }));
}

/** First address of what a list holds: the request's own, or that of the request answered. */
export function firstAddress(
  {
    direction,
    fields: own,
    request,
  }: Pick<Reading, 'direction' | 'fields'> & { readonly request: Pick<Reading, 'fields'> | undefined },
  listName: string,
): number | undefined {
  const from = direction === 'request' ? own : request?.fields;
  const names =
    listName === 'writeRegisters'
      ? ['writeStartAddress']
      : direction === 'response'
        ? ['startAddress', 'readStartAddress']
        : ['startAddress'];
  const found = names.map((name) => from?.[name]).find((value) => typeof value === 'number');
  return found as number | undefined;
}

function readCharacters(bytes: Uint8Array, { from, to }: Span): Uint8Array | undefined {
  const text = String.fromCharCode(...bytes.subarray(from, to));
  return /\s/.test(text) ? undefined : fromHex(text);
}

/** Sections of what stands around the PDU, by name and transport. */
/** Bytes of each item of a list, by its field's kind. */
const WIDTHS: Readonly<Record<string, number>> = dictionary({ registers: 2, bits: 1, list: 1 });

const ENVELOPE: Readonly<Record<string, Section>> = dictionary({
  transactionId: 'TG 3.1.3',
  protocolId: 'TG 3.1.3',
  length: 'TG 3.1.3',
  start: 'SL 2.5.2.1',
  characters: 'SL 2.5.2.1',
  end: 'SL 2.5.2.1',
});

/** The section that lays down a part of the frame outside its PDU. */
export function envelopeSection(transport: Transport, name: string): Section {
  if (name === 'unitId') return transport === 'tcp' ? 'TG 4.4.1.2' : 'SL 2.2';
  if (name === 'checksum') return transport === 'ascii' ? 'SL 2.5.2.2' : 'SL 2.5.1.2';
  return ENVELOPE[name] ?? 'AP 4.1';
}

const OUTSIDE = new Set(['unitId', 'checksum', 'after', ...Object.keys(ENVELOPE)]);

/** The section that lays down the field of this name in this frame. */
export function sectionOf({ transport, description, direction, fields }: Reading, name: string): Section {
  if (OUTSIDE.has(name)) return envelopeSection(transport, name);
  for (const { field, section } of fieldsOf(description, direction, fields)) if (field.name === name) return section;
  return description?.section ?? 'AP 4.1';
}
