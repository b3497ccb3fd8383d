import { zeroBasedAddress } from '../../../notation/index.ts';
import { fields, page } from '../../parts/store.ts';

/** The address of the first item of a list that a request writes; `undefined` if the frame does not say it. */
export function firstOf(path: string): number | undefined {
  if (page.kind.value !== 'request' || path.includes('.')) return undefined;
  const from = fields.at(path === 'writeRegisters' ? 'writeStartAddress' : 'startAddress');
  return zeroBasedAddress(from.field.value ? from.text.value : '0');
}
