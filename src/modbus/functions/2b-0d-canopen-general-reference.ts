import { layout } from '../field.ts';
import { hex } from '../fields/raw-bytes.ts';

/** The body is CiA's to define (AP Annex B), so here it is raw data. */
const body = layout([hex('meiData')], undefined, 'AP 6.20');

export const canopenGeneralReference = {
  meiType: 0x0d,
  name: 'CANopen General Reference',
  section: 'AP 6.20',
  // CiA's commands can do anything.
  access: 'writes',
  request: body,
  response: body,
} as const;
