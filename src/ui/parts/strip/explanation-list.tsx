import type { ReadonlySignal } from '@preact/signals';
import { type ExplanationForm, explanationText } from '../../../workbench/index.ts';
import type { OpenMenu } from '../../kit/menu.tsx';
import { MenuList } from '../../kit/menu-list.tsx';
import type { ExplainedFrame } from '../explanation/explanation.tsx';
import { useExplanationWords } from '../explanation/explanation-words.ts';
import { useSteady } from '../steady.ts';
import { useWords } from '../words.ts';
import { pictureOf } from './explanation-picture.ts';
import { found } from './found.ts';

type As = ExplanationForm | 'png' | 'svg';

const forms: readonly As[] = ['markdown', 'table', 'png', 'svg'];

interface ExplanationListProps {
  readonly menu: OpenMenu;
  readonly explained: ReadonlySignal<ExplainedFrame | undefined>;
  readonly onCopy: (copied: string | Promise<Blob>) => void;
}

/** The forms in which the explanation of a frame is copied or saved. */
export function ExplanationList({ menu, explained, onCopy }: ExplanationListProps) {
  const { page: pageWords, strip, short } = useWords('page');
  const words = useWords('stripMore');
  const explanationWords = useExplanationWords(
    useSteady(() => (explained.value?.reading.problems.length ?? 0) > 0, [explained]).value,
  );
  const run = (as: As) => {
    const value = explained.peek();
    if (value === undefined) return;
    const of = { ...value, words: explanationWords };
    if (as === 'markdown' || as === 'table') {
      onCopy(explanationText(of, pageWords.columns, as));
      return;
    }
    const picture = pictureOf(of, { strip, short }, found.peek());
    if (as === 'png') onCopy(picture.png());
    else picture.save(words.pictureFile);
  };
  const items = forms.map((as) => ({
    id: as,
    name: words.explanationAs[as][0],
    hint: words.explanationAs[as][1],
    run: () => run(as),
  }));
  return <MenuList menu={menu} items={items} />;
}
