import type { ComponentType } from 'preact';
import type { Finding } from '../../diagnosis/index.ts';
import { loadReadWords, type ReadWords } from '../../words/index.ts';

interface BrokenReplyProps {
  /** The likeliest first. */
  readonly findings: readonly Finding[];
}

/** Findings that are shown: the others are hardly likelier than none. */
const SHOWN = 2;

export async function loadPanel(): Promise<ComponentType<BrokenReplyProps>> {
  const words = await loadReadWords();
  return (props) => <BrokenReply {...props} words={words} />;
}

/** Why what came is not a whole frame. */
function BrokenReply({ findings, words }: BrokenReplyProps & { readonly words: ReadWords }) {
  return (
    <ul class="problems">
      {findings.slice(0, SHOWN).map((finding) => {
        const { title, why } = words.finding(finding);
        return (
          <li key={`${finding.code} ${finding.from}`} data-severity="error">
            <b>{title}</b> {why}
          </li>
        );
      })}
    </ul>
  );
}
