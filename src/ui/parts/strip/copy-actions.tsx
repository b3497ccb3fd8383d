import { type CopyFormat, canCopyAs, copyFormats, hasChecksum } from '../../../workbench/index.ts';
import { InPlace, useCopying } from '../../kit/copy-button.tsx';
import { Menu, type MenuItem } from '../../kit/menu.tsx';
import { useCommand, useKeyOf } from '../commands.ts';
import { useExplained } from '../current-frame.ts';
import { useSteady } from '../steady.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import { copiedAs, formatFor, lastFormat, withChecksum } from './copied-as.ts';

/** Characters of what is copied that its tooltip shows. */
const SHOWN = 200;
/** Characters of each text that the list shows. */
const SAMPLE = 28;

const shorten = (text: string, most: number) => (text.length > most ? `${text.slice(0, most)}…` : text);

interface CopyActionsProps {
  /** Whether the frame is wrong: what is copied is then no frame to send, and another action comes first. */
  readonly wrong: boolean;
}

/** Copies the frame that is shown: in the format used last, or by the list in any other; and a link to it. */
export function CopyActions({ wrong }: CopyActionsProps) {
  const { strip: words } = useWords('page');
  const of = useExplained();
  const stale = useSteady(() => page.shown.value.stale !== undefined).value;
  const possible = useSteady(() => {
    const { reading } = of.value ?? {};
    return {
      formats: reading ? copyFormats.filter((format) => canCopyAs(reading, format)) : [],
      checksum: reading !== undefined && hasChecksum(reading),
    };
  }, [of]).value;
  const format = useSteady(() => formatFor(of.value?.reading), [of]).value;
  const textAs = (as: CopyFormat) => {
    const { value } = of;
    return value === undefined ? '' : copiedAs(as, value.reading, value.bytes, value.names);
  };
  const text = useSteady(() => textAs(format), [of, format]).value;
  const copying = useCopying(text);
  const copyAs = (as: CopyFormat) => {
    lastFormat.value = as;
    copying.copy('frame', textAs(as));
  };
  useCommand('copy-frame', () => copyAs(format));
  const label = stale ? words.copyBefore : wrong ? words.copyWrong : words.copy(format);
  const items = (): readonly MenuItem[] => [
    ...possible.formats.map((as) => ({
      id: as,
      name: words.formats(as),
      hint: shorten(textAs(as), SAMPLE),
      run: () => copyAs(as),
    })),
    ...(possible.checksum
      ? [
          {
            id: 'checksum',
            name: words.withChecksum,
            checked: withChecksum.value,
            run: () => {
              withChecksum.value = !withChecksum.value;
            },
          },
        ]
      : []),
  ];
  const key = useKeyOf('copy-frame');
  return (
    <>
      <span class="split">
        <button
          type="button"
          class={wrong || stale ? undefined : 'first'}
          onClick={() => copyAs(format)}
          {...key}
          title={[shorten(text, SHOWN), key?.title].filter(Boolean).join('\n')}
        >
          <InPlace said={copying.copied === 'frame'} word={words.copied}>
            {label}
            {possible.checksum && !withChecksum.value && <small>, {words.noChecksum}</small>}
          </InPlace>
        </button>
        <Menu label={words.copyAs} class={wrong || stale ? '' : 'first'} items={items}>
          ▾
        </Menu>
      </span>
      <button
        type="button"
        title={words.linkHint}
        onClick={() => {
          page.address.now();
          copying.copy('link', location.href);
        }}
      >
        <InPlace said={copying.copied === 'link'} word={words.copied}>
          {words.link}
        </InPlace>
      </button>
      <output class="unseen">{copying.copied !== undefined && words.copied}</output>
      {copying.refused !== undefined && (
        <output class="refused">
          {words.copyFailed} <span class="mono">{copying.refused}</span>
        </output>
      )}
    </>
  );
}
