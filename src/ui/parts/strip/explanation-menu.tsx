import { InPlace, useCopying } from '../../kit/copy-button.tsx';
import { Menu } from '../../kit/menu.tsx';
import { useExplained } from '../current-frame.ts';
import { part, Slot } from '../slot.tsx';
import { useWords } from '../words.ts';

const list = part(
  ['stripMore'],
  () => import('./explanation-list.tsx'),
  ({ ExplanationList }) => ExplanationList,
);

/** Copies the explanation of the frame that is shown: as text, or as a picture of the strip and its lines. */
export function ExplanationMenu() {
  const { strip: words } = useWords('page');
  const explained = useExplained();
  const copying = useCopying(explained);
  const said = copying.copied !== undefined;
  return (
    <>
      <Menu
        label={said ? words.copied : words.explanationHint}
        list={(menu) => <Slot part={list} with={{ menu, explained, onCopy: (copied) => copying.copy('', copied) }} />}
      >
        <InPlace said={said} word={words.copied}>
          {words.explanation} ▾
        </InPlace>
      </Menu>
      <output class="unseen">{said && words.copied}</output>
    </>
  );
}
