import { useState } from 'preact/hooks';
import type { Profile } from '../../../devices/index.ts';
import {
  type Imported,
  importProfiles,
  LARGEST_PROFILES,
  type ProfileFile,
  profileFiles,
  writeProfileFile,
} from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { download } from '../../kit/download.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { parseCsv } from '../csv.ts';
import { allDevices } from '../device/chosen.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';

interface ExchangeProps {
  readonly inLibrary: boolean;
  readonly profile: Profile | undefined;
  readonly onImported: (imported: Imported) => void;
  readonly onMessage: (message: string) => void;
}

const TYPES: Readonly<Record<ProfileFile, string>> = {
  csv: 'text/csv',
  json: 'application/json',
  'mbmap.json': 'application/json',
  md: 'text/markdown',
};

const fileName = ({ name }: Profile, ending: string) =>
  `${name.replace(/[^\p{L}\p{N}.-]+/gu, '-').replace(/^-|-$/g, '') || 'device'}.${ending}`;

/** Writes a device to a file, and reads devices from a file or from pasted text. */
export function Exchange({ profile, inLibrary, onImported, onMessage }: ExchangeProps) {
  const words = useWords('devices');
  const [pasted, setPasted] = useState('');
  const take = (text: string, name: string) =>
    onImported(importProfiles({ list: allDevices.list, parse: parseCsv, words }, text, name));
  const takeFile = async (file: File): Promise<void> => {
    if (file.size > LARGEST_PROFILES) return onMessage(words.fileTooBig);
    const text = await file.text().catch(() => undefined);
    if (text === undefined) onMessage(words.fileUnread);
    else take(text, file.name.replace(/\.[^.]*$/, ''));
  };
  const save = (of: Profile, ending: ProfileFile) => {
    const name = fileName(of, ending);
    download(writeProfileFile(of, ending), name, TYPES[ending]);
    onMessage(words.exported(name));
  };
  return (
    <>
      {profile && (
        <p class="in-row">
          {profileFiles.map((file) => (
            <button key={file} type="button" onClick={() => save(profile, file)}>
              {words.exports[file]}
            </button>
          ))}
        </p>
      )}
      {page.leavesOut.value && <p class="said">{words.tooLarge}</p>}
      {!inLibrary && (
        <>
          <p class="said">
            <a href="#devices">{words.toLibrary}</a>
          </p>
          <details class="device-import">
            <summary>{words.import}</summary>
            <FileButton
              label={words.importFile}
              accept=".csv,.tsv,.txt,.json,text/csv,application/json"
              onFile={(file) => void takeFile(file)}
            />
            <label>
              {words.paste}
              <textarea
                class="mono"
                rows={4}
                spellcheck={false}
                value={pasted}
                onInput={({ currentTarget }) => setPasted(currentTarget.value)}
              />
            </label>
            <button
              type="button"
              {...disabledFor(pasted.trim() === '' ? words.paste : undefined)}
              onClick={() => take(pasted, words.pastedName)}
            >
              {words.importPasted}
            </button>
          </details>
        </>
      )}
    </>
  );
}
