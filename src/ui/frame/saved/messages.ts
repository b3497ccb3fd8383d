import type { Imported, Naming } from '../../../store/index.ts';
import type { Refusal } from '../../../workbench/index.ts';
import { savedWords as words } from '../examples/shelf-words.ts';
import type { FileOutcome } from './read-file.ts';

/** Why nothing was changed. */
export function refusalText(refusal: Refusal, name: string): string {
  switch (refusal) {
    case 'refused':
      return words.refused;
    case 'full':
      return words.full;
    case 'unreadable':
      return words.unreadableKept;
    case 'gone':
      return words.gone(name);
  }
}

/** What was done under a name, and where it is another than was asked for, that both are kept. */
export function namingLines({ wanted, got }: Naming, done: (name: string) => string): string[] {
  return wanted === got ? [done(got)] : [words.nameTaken(wanted, got)];
}

export function importLines({ added, already }: Imported): string[] {
  const lines = [words.imported(added.length)];
  if (already > 0) lines.push(words.already(already));
  return [
    ...lines,
    ...added.filter(({ wanted, got }) => wanted !== got).flatMap((naming) => namingLines(naming, String)),
  ];
}

/** Why a file gives nothing at all. */
export function fileText(outcome: Exclude<FileOutcome, { kind: 'list' }>, name: string): string {
  switch (outcome.kind) {
    case 'too-big':
      return words.fileTooBig(name);
    case 'unread':
      return words.fileUnread(name);
    case 'unreadable':
      return words.badFile(name, outcome.fault);
  }
}
