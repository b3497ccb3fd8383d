import { fromHex, sameBytes } from '../../../modbus/index.ts';
import type { TraceView } from '../../../store/index.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';

/** What is to be said of the row that is chosen, beside what its bytes say: that it has no reply, or is in no frame. */
export function RowAbout({ of }: { readonly of: TraceView<File> }) {
  const words = useWords('trace');
  of.revision.value;
  const about = of.about.value;
  if (about === undefined || of.chosen.value < 0) return null;
  const { row } = about;
  const shown = page.shown.value.frame?.bytes;
  // Another frame may have become the current one, and a late reply may have come.
  const bytes = fromHex(row.hex);
  const isShown = row.length === 0 || (shown && bytes && sameBytes(shown.subarray(0, bytes.length), bytes));
  const text = isShown && words.about({ ...about, row: of.row(of.chosen.value) ?? row });
  return text ? <p class="error">{text}</p> : null;
}
