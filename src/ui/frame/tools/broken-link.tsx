import { brokenLink as brokenLinkParts } from '../../../workbench/index.ts';
import { brokenLink } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** What of the link that was followed could not be read, and why. */
export function BrokenLinkNotice() {
  const words = useWords('brokenLink');
  const { value: broken } = brokenLink;
  if (broken === undefined) return null;
  const { text, length, unknown, more, newer, tooLong } = brokenLinkParts(broken.hash, broken.reading);
  return (
    <section class="panel" role="alert" data-severity="warning">
      <strong>{words.title}</strong>
      {newer !== undefined && <p>{words.newer(newer)}</p>}
      {unknown.map((part) => (
        <p key={part}>{words.unknown(part)}</p>
      ))}
      {more > 0 && <p>{words.more(more)}</p>}
      {tooLong && <p>{words.tooLong(length)}</p>}
      <p class="mono">{text}</p>
    </section>
  );
}
