import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { formatBytes } from '../../../notation/index.ts';
import {
  characters,
  copyTogether,
  evaluate,
  LONGEST_NAME,
  readLink,
  type SavedFrame,
} from '../../../workbench/index.ts';
import { CopyButton } from '../../kit/copy-button.tsx';
import { formatFor, withChecksum } from '../../parts/strip/copied-as.ts';
import { useWords } from '../../parts/words.ts';
import { openKept } from './saved-frames.ts';

/** Longest frame shown whole, in bytes. */
const SHOWN = 24;

interface RowProps extends SavedFrame {
  readonly renaming: boolean;
  /** Whether it is copied together with others. */
  readonly chosen: boolean;
  readonly onChosen: (is: boolean) => void;
  readonly onRename: (name: string) => void;
  /** With the new name, or without one if the old one is to stay. */
  readonly onRenamed: (name: string, typed?: string) => void;
  readonly onDelete: (name: string) => void;
}

/** A saved frame: its name is a link to it. */
export function SavedRow({ name, link, renaming, chosen, onChosen, onRename, onRenamed, onDelete }: RowProps) {
  const words = useWords('saved');
  const { drawer } = useWords('input');
  const { copied, copyFailed } = useWords('page').strip;
  const frame = useMemo(() => frameOf(link), [link]);
  const text = frame?.text;
  return (
    <li class="saved-frame">
      {renaming ? (
        <RenameForm name={name} onDone={(typed) => onRenamed(name, typed)} />
      ) : (
        <>
          <span class="in-row">
            <input
              type="checkbox"
              aria-label={words.choose(name)}
              checked={chosen}
              onChange={({ currentTarget }) => onChosen(currentTarget.checked)}
            />
            <OpenLink name={name} link={link} />
          </span>
          <span class="row-actions in-row">
            {text && (
              <CopyButton
                label={drawer.copy}
                name={drawer.copyOf(name)}
                text={() => text(name)}
                of={link}
                copied={copied}
                refused={() => copyFailed}
              />
            )}
            <button
              type="button"
              aria-label={words.renameOf(name)}
              data-focus={`rename ${name}`}
              onClick={() => onRename(name)}
            >
              {words.rename}
            </button>
            <button type="button" aria-label={words.removeOf(name)} onClick={() => onDelete(name)}>
              {words.remove}
            </button>
          </span>
        </>
      )}
      {frame && <Bytes {...frame} />}
    </li>
  );
}

/** Opens the frame as one step; as a link it can be copied, and opened in another tab, as any link can. */
function OpenLink({ name, link }: SavedFrame) {
  const open = (event: MouseEvent) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const reading = readLink(link);
    if (reading === undefined) return;
    event.preventDefault();
    openKept(reading.draft);
  };
  return (
    <a
      href={`${location.href.replace(/#.*/, '')}#${link}`}
      class="open"
      data-row
      data-focus={`open ${name}`}
      onClick={open}
    >
      {name}
    </a>
  );
}

/** What a link comes to: its frame, if it has one, and what is copied of it under a name; `undefined` if the link cannot be read. */
function frameOf(link: string) {
  const draft = readLink(link)?.draft;
  if (draft === undefined) return undefined;
  const { frame, errors } = evaluate(draft);
  const write = draft.transport === 'ascii' ? characters : formatBytes;
  const text =
    frame &&
    ((name: string) =>
      copyTogether([{ name, ...frame }], { format: formatFor(frame.reading), checksum: withChecksum.value }));
  return { draft, frame, wrong: errors.size, write, text };
}

/** The bytes of a saved frame, and what they are. */
function Bytes({ draft, frame, wrong, write }: NonNullable<ReturnType<typeof frameOf>>) {
  const words = useWords('saved');
  const { page } = useWords('page');
  const kind = `${page.transports[draft.transport]}, ${page.kinds[draft.kind]}`;
  if (frame === undefined) return <span class="said">{`${kind}. ${words.noFrame(wrong)}`}</span>;
  const { bytes, reading } = frame;
  return (
    <>
      <span class="mono">
        {write(bytes.subarray(0, SHOWN))}
        {bytes.length > SHOWN && '…'}
      </span>
      <span class="said">{`${kind}. ${page.summary(reading, bytes.length, draft.transport)}`}</span>
    </>
  );
}

interface RenameProps {
  readonly name: string;
  readonly onDone: (typed?: string) => void;
}

function RenameForm({ name, onDone }: RenameProps) {
  const words = useWords('saved');
  const [typed, setTyped] = useState(name);
  const form = useRef<HTMLFormElement>(null);
  useLayoutEffect(() => {
    const input = form.current?.querySelector('input');
    // Not every browser gives the focus to what is selected.
    input?.focus();
    input?.select();
  }, []);
  return (
    <form
      class="rename-form in-row"
      ref={form}
      onSubmit={(event) => {
        event.preventDefault();
        onDone(typed);
      }}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return;
        // It closes nothing else.
        event.preventDefault();
        onDone();
      }}
    >
      <NameField label={words.newName(name)} text={typed} onText={setTyped} />
      <button type="submit">{words.keepName}</button>
      <button type="button" onClick={() => onDone()}>
        {words.cancel}
      </button>
    </form>
  );
}

interface NameProps {
  readonly label: string;
  readonly text: string;
  readonly onText: (text: string) => void;
}

/** A name that is typed: the browser itself says what is wrong with it. */
export const NameField = ({ label, text, onText }: NameProps) => (
  <label>
    {label}
    <input
      value={text}
      onInput={({ currentTarget }) => onText(currentTarget.value)}
      required
      pattern=".*\S.*"
      title={useWords('saved').nameMissing}
      maxLength={LONGEST_NAME}
      autocomplete="off"
    />
  </label>
);
