import { useState } from 'preact/hooks';
import { formatBytes } from '../../../notation/index.ts';
import { type CopyFormat, firstCopyFormat, hasChecksum } from '../../../workbench/index.ts';
import { InPlace, useCopying } from '../../kit/copy-button.tsx';
import { Menu } from '../../kit/menu.tsx';
import { useCommand, useKeyOf } from '../commands.ts';
import { useExplained } from '../current-frame.ts';
import { part, Slot, useCode } from '../slot.tsx';
import { useSteady } from '../steady.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import { formatFor, lastFormat, shorten, withChecksum } from './copied-as.ts';

/** Characters of what is copied that its tooltip shows. */
const SHOWN = 200;

const leftOut = part(
  ['devices'],
  () => import('./copy-list.tsx'),
  ({ LeftOut }) => LeftOut,
);

const list = part(
  ['stripMore'],
  () => import('./copy-list.tsx'),
  ({ CopyList }) => CopyList,
);

/** What writes a frame in any other way than as pairs with its checksum. */
const writing = { words: [], load: () => import('./copied-text.ts') };

interface CopyActionsProps {
  /** Whether the frame is wrong: what is copied is then no frame to send, and another action comes first. */
  readonly wrong: boolean;
}

/** Copies the frame that is shown: in the format used last, or by the list in any other; and a link to it. */
export function CopyActions({ wrong }: CopyActionsProps) {
  const { strip: words } = useWords('page');
  const of = useExplained();
  const stale = useSteady(() => page.shown.value.stale !== undefined).value;
  const checksum = useSteady(() => of.value !== undefined && hasChecksum(of.value.reading), [of]).value;
  const wanted = useSteady(() => formatFor(of.value?.reading), [of]).value;
  const writer = useCode(writing, wanted !== firstCopyFormat || !withChecksum.value);
  const format = writer ? wanted : firstCopyFormat;
  const text = useSteady(() => {
    if (of.value === undefined) return '';
    return writer ? writer.copiedAs(format, of.value) : formatBytes(of.value.bytes);
  }, [of, format, writer]).value;
  const copying = useCopying(text);
  const [linked, setLinked] = useState<string>();
  const copyAs = (as: CopyFormat, copied: string) => {
    lastFormat.value = as;
    copying.copy('frame', copied);
  };
  // Until what writes it has come, the button copies the plain bytes, and says so.
  const copy = () => (format === wanted ? copyAs(format, text) : copying.copy('frame', text));
  useCommand('copy-frame', copy);
  const label = stale ? words.copyBefore : wrong ? words.copyWrong : words.copy(format);
  const key = useKeyOf('copy-frame');
  return (
    <>
      <span class="copy-split">
        <button
          type="button"
          class={wrong || stale ? undefined : 'first'}
          onClick={copy}
          {...key}
          title={[shorten(text, SHOWN), key?.title].filter(Boolean).join('\n')}
        >
          <InPlace said={copying.copied === 'frame'} word={words.copied}>
            {label}
            {checksum && writer && !withChecksum.value && <small>, {words.noChecksum}</small>}
          </InPlace>
        </button>
        <Menu
          label={words.copyAs}
          class={wrong || stale ? '' : 'first'}
          list={(menu) => <Slot part={list} with={{ menu, of, onCopy: copyAs }} />}
        >
          ▾
        </Menu>
      </span>
      <button
        type="button"
        title={words.linkHint}
        onClick={() => {
          page.address.now();
          setLinked(text);
          copying.copy('link', page.shared.peek()(location.href));
        }}
      >
        <InPlace said={copying.copied === 'link'} word={words.copied}>
          {words.link}
        </InPlace>
      </button>
      {linked === text && <Slot part={leftOut} with={{}} />}
      <output class="unseen">{copying.copied !== undefined && words.copied}</output>
      {copying.refused !== undefined && (
        <output class="refused">
          {words.copyFailed} <span class="mono">{copying.refused}</span>
        </output>
      )}
    </>
  );
}
