import { LAST_ADDRESS } from '../../../modbus/index.ts';
import { zeroBasedAddress } from '../../../notation/index.ts';
import { fields, page } from '../../parts/store.ts';

/** The address of the first item of a list that a request writes; `undefined` if the frame does not say it, or says none that there is. */
export function firstOf(path: string): number | undefined {
  if (page.kind.value !== 'request' || path.includes('.')) return undefined;
  const from = fields.at(path === 'writeRegisters' ? 'writeStartAddress' : 'startAddress');
  const first = zeroBasedAddress(from.field.value ? from.text.value : '0');
  return first !== undefined && Number.isInteger(first) && first >= 0 && first <= LAST_ADDRESS ? first : undefined;
}
