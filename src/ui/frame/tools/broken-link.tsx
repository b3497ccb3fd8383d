import type { BrokenAddress } from '../../../store/index.ts';
import type { ToolWords } from '../../../words/index.ts';
import { brokenLink } from '../../../workbench/index.ts';

interface NoticeProps {
  readonly broken: BrokenAddress;
  readonly words: ToolWords['brokenLink'];
}

/** What of the link that was followed could not be read, and why. */
export function BrokenLinkNotice({ broken, words }: NoticeProps) {
  const { text, length, unknown, more, newer, tooLong } = brokenLink(broken.hash, broken.reading);
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
