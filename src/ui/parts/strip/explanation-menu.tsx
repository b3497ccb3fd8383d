import { type ExplanationForm, explanationText } from '../../../workbench/index.ts';
import { InPlace, useCopying } from '../../kit/copy-button.tsx';
import { Menu } from '../../kit/menu.tsx';
import { useExplained } from '../current-frame.ts';
import { useExplanationWords } from '../explanation/explanation-words.ts';
import { useSteady } from '../steady.ts';
import { useWords } from '../words.ts';
import { found } from './found.ts';

type As = ExplanationForm | 'png' | 'svg';

const forms: readonly As[] = ['markdown', 'table', 'png', 'svg'];

/** Copies the explanation of the frame that is shown: as text, or as a picture of the strip and its lines. */
export function ExplanationMenu() {
  const { page: pageWords, strip: words, short } = useWords('page');
  const explained = useExplained();
  const explanationWords = useExplanationWords(
    useSteady(() => (explained.value?.reading.problems.length ?? 0) > 0, [explained]).value,
  );
  const copying = useCopying(explained);
  const run = (as: As) => {
    const value = explained.peek();
    if (value === undefined) return;
    const of = { ...value, words: explanationWords };
    if (as === 'markdown' || as === 'table') {
      copying.copy('', explanationText(of, pageWords.columns, as));
      return;
    }
    const made = import('./explanation-picture.ts').then((pictures) =>
      pictures.pictureOf(of, { strip: words, short }, found.peek()),
    );
    if (as === 'png')
      copying.copy(
        '',
        made.then((picture) => picture.png()),
      );
    else void made.then((picture) => picture.save(words.pictureFile));
  };
  return (
    <>
      <Menu
        label={words.explanationHint}
        items={() =>
          forms.map((as) => ({
            id: as,
            name: words.explanationAs[as][0],
            hint: words.explanationAs[as][1],
            run: () => run(as),
          }))
        }
      >
        <InPlace said={copying.copied !== undefined} word={words.copied}>
          {words.explanation} ▾
        </InPlace>
      </Menu>
      <output class="unseen">{copying.copied !== undefined && words.copied}</output>
    </>
  );
}
