import type { Profile } from '../../../devices/index.ts';
import { type ProfileFile, profileFiles, writeProfileFile } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { Fold } from '../../kit/fold.tsx';
import { part, Slot } from '../slot.tsx';
import { page } from '../store.ts';
import { useWords } from '../words.ts';

const importer = part(
  ['library', 'registerMaps', 'devices'],
  () => import('../map-import/importer.tsx'),
  ({ Importer }) => Importer,
);

interface ExchangeProps {
  readonly inLibrary: boolean;
  readonly profile: Profile | undefined;
  readonly onImported: (lines: readonly string[], show?: Profile) => void;
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

/** Writes a device to a file, and imports devices. */
export function Exchange({ profile, inLibrary, onImported, onMessage }: ExchangeProps) {
  const words = useWords('devices');
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
          <Fold summary={words.import} keep>
            {() => <Slot part={importer} with={{ onImported }} />}
          </Fold>
        </>
      )}
    </>
  );
}
