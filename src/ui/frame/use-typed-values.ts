import { draft, fields } from '../parts/store.ts';
import { valueAid } from './values/value-aid.ts';

/** Until the values have a hook of their own. */
export function useTypedValues(path: string, _wrong: boolean) {
  const control = fields.at(path).control.value;
  const aid = control && valueAid.value?.(control, draft.value);
  return { input: aid?.typed, said: aid?.said, wrong: aid?.wrong };
}
