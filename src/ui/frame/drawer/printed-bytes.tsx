import { formatBytes } from '../../../notation/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import type { Example, PrintedComparison } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';

/** The bytes as the source prints them, the wrong ones marked and named as such, as the end of a sentence. */
export function PrintedBytes({ runs }: PrintedComparison) {
  const words = useWords('examples');
  return (
    <>
      {runs.map(({ bytes, wrong }, index) => (
        <span key={index}>
          {wrong ? <mark class="mono">{words.wrongByte(bytes)}</mark> : <span class="mono">{formatBytes(bytes)}</span>}
          {index < runs.length - 1 ? ' ' : '. '}
        </span>
      ))}
    </>
  );
}

/** Which of the printed bytes are wrong and why, and which bytes are missing. */
export function reasonText(
  { fault }: Example,
  { right, printed, wrongAt }: PrintedComparison,
  words: WordsOf<'examples'>,
): string {
  const [low = 0, high = 0] = right.subarray(-2);
  const parts: string[] = [];
  if (fault === 'crc') parts.push(words.wrongCrc(wrongAt, (high << 8) | low));
  if (fault === 'address') parts.push(words.wrongAddress(wrongAt));
  if (printed.length < right.length) parts.push(words.noCheck(right.length - printed.length));
  return parts.join(' ');
}
