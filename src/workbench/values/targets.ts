import { type EntityTable, linesBehind, type Profile, unitScale } from '../../devices/index.ts';
import { decodeFrame, firstAddress, type Values } from '../../modbus/index.ts';
import { type UnitScale, zeroBasedAddress } from '../../notation/index.ts';
import { type Draft, textOf } from '../frame/draft.ts';
import { type Control, type Evaluation, requestOf } from '../frame/evaluate.ts';

/** Where the registers of a field stand in the device. */
export interface Place {
  readonly table: EntityTable;
  /** Zero-based address of the first. */
  readonly first: number;
}

/** Where the registers of a field stand, as far as the form or the answered request says it. */
export function placeOf({ field }: Control, draft: Draft, evaluation: Evaluation): Place | undefined {
  const { table } = evaluation.description;
  if (table === undefined || table === 'file-record') return undefined;
  const own = fieldsOf(draft, evaluation);
  if (field.name === 'value') return typeof own['address'] === 'number' ? { table, first: own['address'] } : undefined;
  const bytes = requestOf(draft);
  const request = bytes && decodeFrame(bytes, { transport: draft.transport, direction: 'request' });
  const direction = draft.kind === 'request' ? 'request' : 'response';
  const first = firstAddress({ direction, fields: own, request }, field.name);
  return first === undefined ? undefined : { table, first };
}

/** The addresses that the form has, be the rest of it legal or not. */
const fieldsOf = (draft: Draft, { controls }: Evaluation): Values =>
  Object.fromEntries(
    controls
      .filter(({ field }) => field.kind === 'address')
      .map(({ path, field }) => [path, zeroBasedAddress(textOf(draft, path, field))]),
  );

/** Where the units of values come from. */
export interface UnitSource {
  readonly device: Profile | undefined;
  /** A person's own scale. */
  readonly own: UnitScale | undefined;
}

/** The units of a value that begins `behind` registers after the first of a field: the device's, then the person's own. */
export function unitsAt({ device, own }: UnitSource, place: Place | undefined, behind: number): readonly UnitScale[] {
  const lines = device && place ? linesBehind(device, place.table, place.first, behind) : [];
  return [...lines.map(unitScale), own].filter((known) => known !== undefined);
}
