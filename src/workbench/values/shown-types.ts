import { isNumberType, isTextType, plainTypeNames, type ValueType } from '../../modbus/index.ts';
import type { ValueView } from '../../notation/index.ts';

/** Types that few devices have: shown when asked for, or where the value that is expected is one of them. */
const RARE: ReadonlySet<ValueType> = new Set(['f16', 'bcd16', 'bcd32']);

/** The readings to be shown in tables: none of a text where there is no text, and rare types only if they are wanted. */
export function shownViews(views: readonly ValueView[], rare: boolean): readonly ValueView[] {
  const types = new Set(views.filter(({ type }) => isShown(type, views, rare)).map(({ type }) => type));
  return views.filter(({ type }) => types.has(type));
}

function isShown(type: ValueType, views: readonly ValueView[], rare: boolean): boolean {
  const of = views.filter((view) => view.type === type);
  const isPlain = isNumberType(type) && plainTypeNames.includes(type);
  if (isTextType(type)) return of.some(({ text }) => text !== '');
  return (isPlain && (rare || !RARE.has(type))) || of.some(({ likely }) => likely?.code.startsWith('expected'));
}
