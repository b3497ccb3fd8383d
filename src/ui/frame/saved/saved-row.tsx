import { Component } from 'preact';
import { formatBytes } from '../../../notation/index.ts';
import { characters, evaluate, LONGEST_NAME, readLink, type SavedFrame } from '../../../workbench/index.ts';
import { words as page } from '../../parts/page-words.ts';
import { takeUp } from '../current-frame.ts';
import { savedWords as words } from '../examples/shelf-words.ts';

/** Longest frame shown whole. */
const SHOWN = 24;

interface RowProps {
  readonly frame: SavedFrame;
  readonly renaming: boolean;
  readonly onRename: () => void;
  /** With the new name, or without where it is to stay. */
  readonly onRenamed: (name: string | undefined) => void;
  readonly onDelete: () => void;
}

/** A saved frame: its name is a link to it. */
export class SavedRow extends Component<RowProps> {
  override shouldComponentUpdate({ frame, renaming }: RowProps) {
    const shown = this.props;
    return frame.name !== shown.frame.name || frame.link !== shown.frame.link || renaming !== shown.renaming;
  }

  render() {
    const { frame, renaming, onRename, onRenamed, onDelete } = this.props;
    const { name, link } = frame;
    return (
      <li class="saved-frame">
        {renaming ? <RenameForm name={name} onDone={onRenamed} /> : <OpenLink name={name} link={link} />}
        {!renaming && (
          <span class="row-actions">
            <button type="button" aria-label={words.renameOf(name)} data-focus={`rename ${name}`} onClick={onRename}>
              {words.rename}
            </button>
            <button type="button" aria-label={words.removeOf(name)} onClick={onDelete}>
              {words.remove}
            </button>
          </span>
        )}
        <Bytes link={link} />
      </li>
    );
  }
}

/** Opens the frame as one step; as a link it can be copied, and opened in another tab, as any link can. */
function OpenLink({ name, link }: SavedFrame) {
  const open = (event: MouseEvent) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const reading = readLink(link);
    if (reading === undefined) return;
    event.preventDefault();
    takeUp(reading.draft);
  };
  return (
    <a href={`#${link}`} data-focus={`open ${name}`} onClick={open}>
      {name}
    </a>
  );
}

function Bytes({ link }: { link: string }) {
  const draft = readLink(link)?.draft;
  if (draft === undefined) return null;
  const { frame, errors } = evaluate(draft);
  const kind = `${page.page.transports[draft.transport]}, ${page.page.kinds[draft.kind]}`;
  if (frame === undefined) return <span class="said">{`${kind}. ${words.noFrame(errors.size)}`}</span>;
  const { bytes, reading } = frame;
  const shown = bytes.subarray(0, SHOWN);
  return (
    <>
      <span class="mono">
        {draft.transport === 'ascii' ? characters(shown) : formatBytes(shown)}
        {bytes.length > SHOWN && '…'}
      </span>
      <span class="said">{`${kind}. ${page.page.summary(reading, bytes.length, draft.transport)}`}</span>
    </>
  );
}

interface RenameProps {
  readonly name: string;
  readonly onDone: (name: string | undefined) => void;
}

class RenameForm extends Component<RenameProps> {
  private input: HTMLInputElement | null = null;

  override componentDidMount() {
    this.input?.select();
  }

  render() {
    const { name, onDone } = this.props;
    return (
      <form
        class="rename-form"
        onSubmit={(event) => {
          event.preventDefault();
          onDone(this.input?.value);
        }}
        onKeyDown={(event) => {
          if (event.key !== 'Escape') return;
          event.preventDefault();
          onDone(undefined);
        }}
      >
        <NameField
          label={words.newName(name)}
          value={name}
          takeInput={(input) => {
            this.input = input;
          }}
        />
        <button type="submit">{words.keepName}</button>
        <button type="button" onClick={() => onDone(undefined)}>
          {words.cancel}
        </button>
      </form>
    );
  }
}

interface NameProps {
  readonly label: string;
  readonly value: string;
  /** Takes the input itself: what is typed is asked for when it counts. */
  readonly takeInput: (input: HTMLInputElement | null) => void;
}

/** A name that is typed: the browser itself says what is wrong with it. */
export const NameField = ({ label, value, takeInput }: NameProps) => (
  <label>
    {label}
    <input
      ref={takeInput}
      defaultValue={value}
      required
      pattern=".*\S.*"
      title={words.nameMissing}
      maxLength={LONGEST_NAME}
      autocomplete="off"
    />
  </label>
);
