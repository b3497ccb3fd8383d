import { useState } from 'preact/hooks';
import type { Profile } from '../../../devices/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { useWords } from '../words.ts';
import { ImportAssistant } from './import-assistant.tsx';
import { useMapImport } from './use-map-import.ts';

interface ImporterProps {
  /** Sentences about what was done, and the device that is shown then. */
  readonly onImported: (lines: readonly string[], show?: Profile) => void;
}

/** Imports a map from a file or from pasted text: at once what leaves nothing to ask, all others by the assistant. */
export function Importer({ onImported }: ImporterProps) {
  const words = useWords('devices');
  const { unread } = useWords('library');
  const [pasted, setPasted] = useState('');
  const { mapImport, sourceOf } = useMapImport((line) => onImported(line === '' ? [] : [line]));
  const told = (profile: Profile, wanted: string) => [
    words.imported(profile.name, profile.registers.length),
    ...(profile.name === wanted ? [] : [words.nameTaken(wanted, profile.name)]),
  ];
  const take = async (what: File | string) => {
    const source = await sourceOf(what);
    if (source === undefined) return;
    const taken = await mapImport.take(source);
    if (typeof taken === 'string') return onImported([taken === 'unread' ? unread : words.refusals[taken]]);
    onImported(
      taken.flatMap(({ kind, profile, wanted }) =>
        kind === 'here' ? [words.already(profile.name)] : told(profile, wanted),
      ),
      taken.at(-1)?.profile,
    );
  };
  return (
    <>
      <FileButton label={words.importFile} onFile={(file) => void take(file)} />
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
        onClick={() => void take(pasted)}
      >
        {words.importPasted}
      </button>
      {mapImport.source.value && (
        <ImportAssistant of={mapImport} onKept={(profile, wanted) => onImported(told(profile, wanted), profile)} />
      )}
    </>
  );
}
