import type { ComponentType } from 'preact';
import type { Finding } from '../../diagnosis/index.ts';
import { type FindingWords, loadFindingWords } from '../../words/index.ts';

interface BrokenReplyProps {
  /** The likeliest first. */
  readonly findings: readonly Finding[];
}

/** Findings that are shown: the others are hardly likelier than none. */
const SHOWN = 2;

export async function loadPanel(): Promise<ComponentType<BrokenReplyProps>> {
  const say = await loadFindingWords();
  return (props) => <BrokenReply {...props} say={say} />;
}

/** Why what came is not a valid frame. */
function BrokenReply({ findings, say }: BrokenReplyProps & { readonly say: (finding: Finding) => FindingWords }) {
  return (
    <ul class="problems">
      {findings.slice(0, SHOWN).map((finding) => {
        const { title, why } = say(finding);
        return (
          <li key={`${finding.code} ${finding.from}`} data-severity="error">
            <b>{title}</b> {why}
          </li>
        );
      })}
    </ul>
  );
}
