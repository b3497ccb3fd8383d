import { plainName, type Removed, type SavedFrame, writeSaved } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { FoldPanel } from '../../kit/fold.tsx';
import { page } from '../../parts/store.ts';
import { savedWords as words } from '../examples/shelf-words.ts';
import { KeptPanel } from '../kept-panel.ts';
import { fileText, importLines, namingLines, refusalText } from './messages.ts';
import { readFile } from './read-file.ts';
import { savedFrames } from './saved-frames.ts';
import { NameField, SavedRow } from './saved-row.tsx';
import { StorageFault } from './storage-fault.tsx';

interface PanelState {
  readonly said?: readonly string[];
  readonly renaming?: string | undefined;
  /** What was deleted, the latest last. */
  readonly deleted?: readonly Removed<SavedFrame>[];
  readonly focus?: string | undefined;
}

/** Frames kept in this browser under their names. */
export class SavedPanel extends KeptPanel<unknown, PanelState> {
  private name: HTMLInputElement | null = null;

  private say(said: readonly string[], more: PanelState = {}): void {
    this.setState({ ...more, said });
  }

  private readonly save = (event: Event): void => {
    event.preventDefault();
    const name = plainName(this.name?.value ?? '');
    const outcome = savedFrames.save(name, page.link.value);
    if (typeof outcome === 'string') {
      this.say([refusalText(outcome, name)]);
    } else {
      if (this.name) this.name.value = '';
      this.say(namingLines(outcome, words.savedAs));
    }
  };

  private rename(from: string, typed: string | undefined): void {
    const to = plainName(typed ?? from);
    const outcome = to === from ? { wanted: from, got: from } : savedFrames.rename(from, to);
    if (typeof outcome === 'string') {
      this.say([refusalText(outcome, from)]);
    } else {
      const said = to === from ? [] : namingLines(outcome, words.renamedTo);
      this.say(said, { renaming: undefined, focus: `rename ${outcome.got}` });
    }
  }

  private remove(name: string): void {
    const outcome = savedFrames.delete(name);
    if (typeof outcome === 'string') {
      this.say([refusalText(outcome, name)]);
    } else {
      this.say([words.removed(name)], { deleted: [...(this.state.deleted ?? []), outcome], focus: 'undo' });
    }
  }

  private restore(last: Removed<SavedFrame>): void {
    const outcome = savedFrames.restore(last);
    if (typeof outcome === 'string') {
      this.say([refusalText(outcome, last.item.name)]);
    } else {
      const deleted = this.state.deleted?.slice(0, -1) ?? [];
      this.say(namingLines(outcome, words.restored), { deleted, focus: `open ${outcome.got}` });
    }
  }

  private readonly import = async (file: File): Promise<void> => {
    const outcome = await readFile(file);
    if (outcome.kind !== 'list') {
      this.say([fileText(outcome, file.name)]);
      return;
    }
    const imported = savedFrames.import(outcome.frames);
    const bad = outcome.bad.map(({ row, why }) => words.badRow(row, why));
    this.say([...(typeof imported === 'string' ? [refusalText(imported, file.name)] : importLines(imported)), ...bad]);
  };

  render() {
    const { value } = savedFrames.stored;
    const frames = value.kind === 'list' ? value.items : [];
    return (
      <FoldPanel root={this.takeRoot} title={words.title} hint={frames.length > 0 ? frames.length : undefined}>
        <p class="said">{words.intro}</p>
        <StorageFault onSaid={(said) => this.say([said])} />
        <form class="save-form" onSubmit={this.save}>
          <NameField
            label={words.name}
            value=""
            takeInput={(input) => {
              this.name = input;
            }}
          />
          <button type="submit" class="first">
            {words.save}
          </button>
        </form>
        {this.rows()}
        <div class="save-form">
          <button
            type="button"
            disabled={frames.length === 0}
            onClick={() => {
              download(writeSaved(frames), words.fileName);
              this.say([words.exported(frames.length)]);
            }}
          >
            {words.export}
          </button>
          <FileButton label={words.import} accept=".json,application/json" onFile={(file) => void this.import(file)} />
        </div>
        {this.says()}
      </FoldPanel>
    );
  }

  private rows() {
    const { value } = savedFrames.stored;
    if (value.kind !== 'list') return null;
    if (value.items.length === 0) return <p class="said">{words.empty}</p>;
    return (
      <ul aria-label={words.list}>
        {value.items.map((frame) => (
          <SavedRow
            key={frame.name}
            frame={frame}
            renaming={this.state.renaming === frame.name}
            onRename={() => this.setState({ renaming: frame.name })}
            onRenamed={(name) => this.rename(frame.name, name)}
            onDelete={() => this.remove(frame.name)}
          />
        ))}
      </ul>
    );
  }

  /** What was done, and the way back from the latest deletion. */
  private says() {
    const { said = [], deleted } = this.state;
    const last = deleted?.at(-1);
    return (
      <div class="saved-says">
        <div role="status">
          {said.map((line, index) => (
            <p key={index}>{line}</p>
          ))}
        </div>
        {last && (
          <p>
            <button type="button" data-focus="undo" onClick={() => this.restore(last)}>
              {words.undo(last.item.name)}
            </button>
          </p>
        )}
      </div>
    );
  }
}
