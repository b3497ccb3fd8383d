import { type Profile, writeMbmap, writeProfiles, writeTable } from '../../devices/index.ts';
import { writeCsvFile, writeTableText } from '../../notation/index.ts';

/** The files that a profile is written to, by their endings. */
export const profileFiles = ['csv', 'json', 'mbmap.json', 'md'] as const;
export type ProfileFile = (typeof profileFiles)[number];

const WRITERS: Readonly<Record<ProfileFile, (profile: Profile) => string>> = {
  // With the mark by which spreadsheets know UTF-8.
  csv: (profile) => writeCsvFile(writeTable(profile), 'marked'),
  json: (profile) => writeProfiles([profile]),
  'mbmap.json': writeMbmap,
  md: markdown,
};

export const writeProfileFile = (profile: Profile, file: ProfileFile): string => WRITERS[file](profile);

/** Its registers as a table to read; the columns that no register fills are left out. */
function markdown(profile: Profile): string {
  const [head = [], ...lines] = writeTable(profile).filter(([first = '']) => !first.startsWith('#'));
  const filled = head.flatMap((_, at) => (lines.some((cells) => (cells[at] ?? '') !== '') ? [at] : []));
  const rows = [head, ...lines].map((cells) => filled.map((at) => (cells[at] ?? '').replace(/\s*[\r\n]+\s*/g, ' ')));
  return `# ${profile.name}\n\n${profile.source === '' ? '' : `${profile.source}\n\n`}${writeTableText(rows, 'markdown')}\n`;
}
