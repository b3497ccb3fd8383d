import { readProfiles } from '../../json.ts';
import { writeTable } from '../../table.ts';
import { isObject } from '../loose.ts';
import type { Sheet, SheetProblem } from '../sheet.ts';

export const FORMAT = 'framewright';

/** Our own file of profiles, of any version, as the tables that we write; `undefined` of another value. */
export function readOwn(text: string, value: unknown, problems: SheetProblem[]): readonly Sheet[] | undefined {
  if (!isObject(value) || value['format'] !== 'framewright-devices') return undefined;
  const read = readProfiles(text);
  if (read.kind === 'unreadable') {
    problems.push({ code: 'own-file', fault: read.fault });
    return [];
  }
  return read.profiles.map(({ profile, faults }) => {
    for (const { line, ...fault } of faults) problems.push({ code: 'own-table', fault, line });
    const rows = writeTable(profile).map((cells, index) => ({ line: index + 1, cells }));
    return { name: profile.name, kind: 'named', format: FORMAT, rows };
  });
}
