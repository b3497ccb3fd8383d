import type { ReadonlySignal } from '@preact/signals';
import { type CopyFormat, canCopyAs, copyFormats, hasChecksum } from '../../../workbench/index.ts';
import type { OpenMenu } from '../../kit/menu.tsx';
import { MenuList } from '../../kit/menu-list.tsx';
import type { ExplainedFrame } from '../explanation/explanation.tsx';
import { useWords } from '../words.ts';
import { copiedAs, shorten, withChecksum } from './copied-as.ts';

/** Characters of each text that the list shows. */
const SAMPLE = 28;

interface CopyListProps {
  readonly menu: OpenMenu;
  readonly of: ReadonlySignal<ExplainedFrame | undefined>;
  readonly onCopy: (as: CopyFormat) => void;
}

/** Every format in which the frame can be copied, with what is copied, and whether the checksum is. */
export function CopyList({ menu, of, onCopy }: CopyListProps) {
  const { strip: words } = useWords('page');
  const { value: frame } = of;
  if (frame === undefined) return <MenuList menu={menu} items={[]} />;
  const formats = copyFormats
    .filter((as) => canCopyAs(frame.reading, as))
    .map((as) => ({
      id: as,
      name: words.formats(as),
      hint: shorten(copiedAs(as, frame), SAMPLE),
      run: () => onCopy(as),
    }));
  const checksum = {
    id: 'checksum',
    name: words.withChecksum,
    checked: withChecksum.value,
    run: () => {
      withChecksum.value = !withChecksum.value;
    },
  };
  return <MenuList menu={menu} items={hasChecksum(frame.reading) ? [...formats, checksum] : formats} />;
}
