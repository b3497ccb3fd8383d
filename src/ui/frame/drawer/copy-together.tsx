import {
  type CopyFormat,
  canCopyAs,
  copyFormats,
  copyTogether,
  type Draft,
  evaluate,
} from '../../../workbench/index.ts';
import { InPlace, useCopying } from '../../kit/copy-button.tsx';
import { Menu, type OpenMenu } from '../../kit/menu.tsx';
import { MenuList } from '../../kit/menu-list.tsx';
import { lastFormat, shorten, withChecksum } from '../../parts/strip/copied-as.ts';
import { useWords } from '../../parts/words.ts';

/** Characters of what is copied that the list shows. */
const SAMPLE = 28;

/** A frame as it was typed, under its name. */
export interface NamedDraft {
  readonly name: string;
  readonly draft: Draft;
}

interface CopyTogetherProps {
  readonly frames: readonly NamedDraft[];
  readonly label: string;
  /** What the button copies, for those who hear it. */
  readonly name?: string;
}

/** Copies frames at once, each on a line and in programs under its name, in a format that is chosen from a list. */
export function CopyTogether({ frames, label, name = label }: CopyTogetherProps) {
  const { copied, copyFailed } = useWords('page').strip;
  const copying = useCopying(name);
  const said = copying.copied !== undefined;
  return (
    <>
      <Menu
        label={said ? copied : name}
        list={(menu) => <FormatList menu={menu} frames={frames} onCopy={copying.copy} />}
      >
        <InPlace said={said} word={copied}>
          {label} ▾
        </InPlace>
      </Menu>
      <output class="unseen">{said && copied}</output>
      {copying.refused !== undefined && (
        <output class="refused">
          {copyFailed} <span class="mono">{copying.refused}</span>
        </output>
      )}
    </>
  );
}

interface FormatListProps {
  readonly menu: OpenMenu;
  readonly frames: readonly NamedDraft[];
  readonly onCopy: (id: string, text: string) => void;
}

/** The formats that all frames have, with what is copied in each. */
function FormatList({ menu, frames, onCopy }: FormatListProps) {
  const { formats } = useWords('stripMore');
  const given = frames.flatMap(({ name, draft }) => {
    const { frame } = evaluate(draft);
    return frame ? [{ name, ...frame }] : [];
  });
  const item = (as: CopyFormat) => {
    const text = copyTogether(given, { format: as, checksum: withChecksum.value });
    const run = () => {
      lastFormat.value = as;
      onCopy(as, text);
    };
    return { id: as, name: formats[as], hint: shorten(text, SAMPLE), run };
  };
  const ofAll = copyFormats.filter((as) => given.every(({ reading }) => canCopyAs(reading, as)));
  return <MenuList menu={menu} items={ofAll.map(item)} />;
}
