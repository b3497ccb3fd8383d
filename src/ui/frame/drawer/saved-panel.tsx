import { useState } from 'preact/hooks';
import type { Naming } from '../../../store/index.ts';
import { plainName, programForFrames, type Refusal, readLink, writeSaved } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { download } from '../../kit/download.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { Messages } from '../../kit/messages.tsx';
import { useFocus } from '../../kit/use-focus.ts';
import { KeptFault } from '../../parts/kept-fault.tsx';
import { ProgramButton } from '../../parts/program/program-button.tsx';
import { page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { CopyTogether } from './copy-together.tsx';
import { importFile, listed, namingText, savedFrames } from './saved-frames.ts';
import { NameField, SavedRow } from './saved-row.tsx';

/** Frames kept in this browser under their names. */
export function SavedPanel() {
  const words = useWords('saved');
  const { root, focus } = useFocus<HTMLDivElement>();
  const [messages, say] = useState<readonly string[]>([]);
  const [name, setName] = useState('');
  const [renaming, setRenaming] = useState<string>();
  const [marked, mark] = useState<readonly string[]>([]);
  const frames = listed.value;
  const last = savedFrames.deleted.value.at(-1);
  const chosen = frames.filter((frame) => marked.includes(frame.name));
  const drafts = (chosen.length > 0 ? chosen : frames).flatMap(({ name: of, link }) => {
    const draft = readLink(link)?.draft;
    return draft ? [{ name: of, draft }] : [];
  });

  /** Tells the result of a change, and answers the name that the frame has now; `undefined` if nothing was changed. */
  const told = (outcome: Naming | Refusal, done: (got: string) => string): string | undefined => {
    if (typeof outcome === 'string') {
      say([words.refusals[outcome]]);
      return undefined;
    }
    say([namingText(words, outcome, done)]);
    return outcome.got;
  };

  const save = (event: Event) => {
    event.preventDefault();
    const plain = plainName(name);
    if (told(savedFrames.save(plain, page.frameLink.value), words.savedAs) !== undefined) setName('');
  };

  const rename = (from: string, typed = from) => {
    const to = plainName(typed);
    if (to === from) say([]);
    const got = to === from ? from : told(savedFrames.rename(from, to), words.renamedTo);
    if (got === undefined) return;
    setRenaming(undefined);
    focus(`rename ${got}`);
  };

  const remove = (of: string) => {
    const outcome = savedFrames.delete(of);
    if (typeof outcome === 'string') {
      say([words.refusals[outcome]]);
    } else {
      say([words.removed(of)]);
      focus('undo');
    }
  };

  const undo = () => {
    const got = told(savedFrames.undo(), words.restored);
    if (got !== undefined) focus(`open ${got}`);
  };

  return (
    <div ref={root}>
      <p class="said">{words.intro}</p>
      <KeptFault list={savedFrames} words={words} onMessage={(line) => say([line])} />
      <form class="save-form in-row" onSubmit={save}>
        <NameField label={words.name} text={name} onText={setName} />
        <button type="submit" class="first">
          {words.save}
        </button>
      </form>
      {savedFrames.stored.value.kind === 'list' && frames.length === 0 && <p class="said">{words.empty}</p>}
      {frames.length > 0 && (
        <ul class="kept-frames" aria-label={words.list}>
          {frames.map((frame) => (
            <SavedRow
              key={frame.name}
              {...frame}
              renaming={renaming === frame.name}
              chosen={marked.includes(frame.name)}
              onChosen={(is) => mark([...marked.filter((other) => other !== frame.name), ...(is ? [frame.name] : [])])}
              onRename={setRenaming}
              onRenamed={rename}
              onDelete={remove}
            />
          ))}
        </ul>
      )}
      <div class="save-form in-row">
        {frames.length > 0 && (
          <>
            <CopyTogether
              frames={drafts}
              label={chosen.length > 0 ? words.copyChosen(chosen.length) : words.copyAll(frames.length)}
            />
            <ProgramButton
              label={chosen.length > 0 ? words.programOfChosen(chosen.length) : words.programOfAll(frames.length)}
              name={drafts.map(({ name: of }) => of).join(', ')}
              wanted={() => programForFrames(drafts)}
            />
          </>
        )}
        <button
          type="button"
          {...disabledFor(frames.length === 0 ? words.empty : undefined)}
          onClick={() => {
            download(writeSaved(frames), words.fileName);
            say([words.exported(frames.length)]);
          }}
        >
          {words.export}
        </button>
        <FileButton
          label={words.import}
          accept=".json,application/json"
          onFile={(file) => void importFile(file, words).then(say)}
        />
      </div>
      <Messages lines={messages}>
        {last && (
          <button type="button" data-focus="undo" onClick={undo}>
            {words.undo(last.item.name)}
          </button>
        )}
      </Messages>
    </div>
  );
}
