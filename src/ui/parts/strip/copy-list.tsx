import type { ReadonlySignal } from '@preact/signals';
import { type CopyFormat, canCopyAs, copyFormats, hasChecksum } from '../../../workbench/index.ts';
import type { OpenMenu } from '../../kit/menu.tsx';
import { MenuList } from '../../kit/menu-list.tsx';
import type { ExplainedFrame } from '../explanation/explanation.tsx';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import { shorten, withChecksum } from './copied-as.ts';
import { copiedAs } from './copied-text.ts';

/** Characters of each text that the list shows. */
const SAMPLE = 28;

interface CopyListProps {
  readonly menu: OpenMenu;
  readonly of: ReadonlySignal<ExplainedFrame | undefined>;
  readonly onCopy: (as: CopyFormat, text: string) => void;
}

/** Every format in which the frame can be copied, with what is copied, and whether the checksum is. */
export function CopyList({ menu, of, onCopy }: CopyListProps) {
  const words = useWords('stripMore');
  const { value: frame } = of;
  if (frame === undefined) return <MenuList menu={menu} items={[]} />;
  const formats = copyFormats
    .filter((as) => canCopyAs(frame.reading, as))
    .map((as) => {
      const text = copiedAs(as, frame);
      return { id: as, name: words.formats[as], hint: shorten(text, SAMPLE), run: () => onCopy(as, text) };
    });
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

/** Said once a link was copied that lacks the device. */
export function LeftOut() {
  const { tooLarge } = useWords('devices');
  return page.leavesOut.value && <output class="refused">{tooLarge}</output>;
}
