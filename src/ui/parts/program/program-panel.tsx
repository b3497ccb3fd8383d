import { useId, useMemo } from 'preact/hooks';
import { type Program, programParts, targetProof } from '../../../codegen/index.ts';
import type { Reading } from '../../../modbus/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import {
  bytesByLine,
  type OfferedTarget,
  offeredParts,
  offeredTargets,
  type ProgramFor,
  writtenProgram,
} from '../../../workbench/index.ts';
import { Choice } from '../../kit/choice.tsx';
import { CopyButton } from '../../kit/copy-button.tsx';
import { download } from '../../kit/download.ts';
import { useWords } from '../words.ts';
import { CodeView } from './code-view.tsx';
import { GuideListingButton } from './guide-listing.tsx';
import { highlighting } from './languages.ts';
import './program.css';
import { ProgramOptions } from './program-options.tsx';
import { programs } from './program-store.ts';
import { SaveAll } from './save-all.tsx';

export interface ProgramPanelProps {
  readonly wanted: ProgramFor;
  /** The frame in the strip, whose bytes the lines of the program light. */
  readonly reading?: Reading | undefined;
}

/** A program: its target, its part and its options, what there is to know of it, and its text. */
export function ProgramPanel({ wanted, reading }: ProgramPanelProps) {
  const words = useWords('program');
  const { target } = programs.choice.value;
  const options = programs.options.value;
  const subject = wanted.kind === 'subject' ? wanted.subject : undefined;
  const sequence = subject !== undefined && 'sequence' in subject;
  const transport = wanted.kind === 'subject' ? wanted.transport : (reading?.transport ?? 'rtu');
  const program = useMemo(
    () => subject && writtenProgram(target, subject, sequence ? { ...options, part: 'exchange' } : options),
    [target, subject, options],
  );
  const targets = offeredTargets(transport, sequence);
  const chosen = targets.find(({ id }) => id === target);
  return (
    <div class="program">
      <Choices targets={targets} sequence={sequence} words={words} />
      <ProgramOptions transport={transport} />
      {wanted.kind === 'none' && <p class="said error">{words.none[wanted.why]}</p>}
      {subject && program === undefined && <p class="said error">{words.notWritten}</p>}
      {wanted.kind === 'subject' && program && chosen && (
        <Written program={program} target={chosen} reading={reading} wanted={wanted} words={words} />
      )}
    </div>
  );
}

interface ChoicesProps {
  readonly targets: readonly OfferedTarget[];
  readonly sequence: boolean;
  readonly words: WordsOf<'program'>;
}

function Choices({ targets, sequence, words }: ChoicesProps) {
  const id = useId();
  const { target, part } = programs.choice.value;
  const parts = offeredParts(target, sequence);
  const shown = sequence ? 'exchange' : part;
  const unknown = programs.unknown.value;
  return (
    <>
      <div class="program-choices">
        <Choice
          id={`${id}-target`}
          label={words.target}
          value={target}
          options={targets.map(({ id: value, name, group }) => ({
            value,
            name,
            group: group === undefined ? words.otherGroup : words.groups[group],
          }))}
          onChoose={programs.chooseTarget}
        />
        <Choice
          id={`${id}-part`}
          label={words.part}
          value={shown}
          options={programParts
            .filter((each) => parts.includes(each) || each === shown)
            .map((each) => ({ value: each, name: words.parts[each], disabled: !parts.includes(each) }))}
          onChoose={programs.choosePart}
        />
      </div>
      {unknown !== undefined && <p class="said error">{words.unknownTarget(unknown)}</p>}
    </>
  );
}

interface WrittenProps {
  readonly program: Program;
  readonly target: OfferedTarget;
  readonly reading: Reading | undefined;
  readonly wanted: Extract<ProgramFor, { kind: 'subject' }>;
  readonly words: WordsOf<'program'>;
}

/** The files of a program, and what there is to know of it. */
function Written({ program, target, reading, wanted, words }: WrittenProps) {
  const { files, notes } = program;
  return (
    <>
      {notes.length > 0 && (
        <ul class="edges program-notes" aria-label={words.about}>
          {notes.map(({ code, ...data }, index) => (
            <li key={index} data-severity={code === 'not-offered' ? 'warning' : 'note'}>
              {words.note(code, data, target.name)}
            </li>
          ))}
        </ul>
      )}
      {files.map(({ name, text }, file) => (
        <div key={name}>
          <div class="in-row program-file">
            <b class="mono">{name}</b>
            <CopyButton
              label={words.copy}
              name={words.copyFile(name)}
              text={() => text}
              copied={words.copied}
              refused={() => words.copyFailed}
              of={text}
            />
            <button type="button" aria-label={words.saveFile(name)} onClick={() => download(text, name, 'text/plain')}>
              {words.save}
            </button>
            {file === 0 && <SaveAll wanted={wanted} files={files} target={target.id} />}
          </div>
          {name.endsWith('.svg') && (
            <img
              class="program-picture"
              alt={words.picture(name)}
              src={`data:image/svg+xml,${encodeURIComponent(text)}`}
            />
          )}
          <CodeView
            key={target.id}
            label={words.code(name)}
            text={text}
            highlighting={highlighting(target.language, name)}
            bytes={linesOf(program, file, reading)}
          />
        </div>
      ))}
      <p class="said">{provedText(target, words)}</p>
      {target.group === 'plc' && (
        <div>
          <GuideListingButton />
        </div>
      )}
    </>
  );
}

/** What the lines of a file light. */
function linesOf(program: Program, file: number, reading: Reading | undefined) {
  if (reading === undefined) return new Map();
  const kinds = new Map(reading.spans.map(({ from, kind }) => [from, kind]));
  const ranges = bytesByLine(program, file, reading);
  return new Map(Array.from(ranges, ([line, range]) => [line, { ...range, kind: kinds.get(range.from) ?? '' }]));
}

function provedText({ id, proof }: OfferedTarget, { proved }: WordsOf<'program'>): string {
  if (proof === 'rules') return proved.rules;
  const known = targetProof(id);
  return known === undefined ? proved.run : proved.by[known.how](known);
}
