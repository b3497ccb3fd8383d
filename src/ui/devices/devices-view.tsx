import { useLayoutEffect, useState } from 'preact/hooks';
import { AddressedView } from '../../store/index.ts';
import { FileButton } from '../kit/file-button.tsx';
import { Messages } from '../kit/messages.tsx';
import { allDevices, ChosenDevice, onceCame } from '../parts/device/chosen.ts';
import { DevicePanel } from '../parts/device-panel/device-panel.tsx';
import { useMapImport } from '../parts/map-import/use-map-import.ts';
import { part, Slot } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { useView } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import './devices-view.css';
import { Library } from './library.tsx';
import { MapComparison } from './map-comparison.tsx';

const assistant = part(
  ['library', 'registerMaps', 'devices'],
  () => import('../parts/map-import/import-assistant.tsx'),
  ({ ImportAssistant }) => ImportAssistant,
);

/** All profiles, the map of the chosen one, and the import of maps of any maker. */
export const DevicesView = onceCame(Devices);

function Devices() {
  const words = useWords('library');
  const [said, say] = useState('');
  const { mapImport, sourceOf } = useMapImport(say);
  const { shown, change } = useView(
    words.title,
    () =>
      new AddressedView(
        page,
        'devices',
        (parts) => ({ search: parts.get('search') ?? '' }),
        (typed) => typed,
      ),
  );
  const open = async (what: File | string) => {
    const source = await sourceOf(what);
    if (source) say((await mapImport.open(source)) ? '' : words.unread);
  };
  useLayoutEffect(() => takeWhatComes(open), []);
  const profile = allDevices.chosen.value;
  return (
    <main class="devices">
      <ChosenDevice />
      <div class="rail stack">
        <Library search={shown.value.search} onSearch={(search) => change({ search })} />
        <section class="panel" aria-labelledby="import-map">
          <h2 id="import-map">{words.import}</h2>
          <p class="soft">{words.importHint}</p>
          <FileButton label={words.chooseFile} onFile={(file) => void open(file)} />
        </section>
      </div>
      <div class="stack">
        {said !== '' && <Messages lines={[said]} />}
        {mapImport.source.value && (
          <Slot
            part={assistant}
            with={{ of: mapImport, onKept: ({ name, registers }) => say(words.imported(name, registers.length)) }}
          />
        )}
        <section class="panel" aria-labelledby="device-map">
          <h2 id="device-map">{profile ? words.map(profile.name) : words.noMap}</h2>
          <DevicePanel inLibrary />
        </section>
        {profile && <MapComparison profile={profile} />}
      </div>
    </main>
  );
}

/** What is dropped or pasted here outside of fields is a map. Answers how to end that. */
function takeWhatComes(open: (what: File | string) => Promise<void> | void): () => void {
  const take = (event: Event, data: DataTransfer | null) => {
    const file = data?.files[0];
    const typed = event.target instanceof Element && event.target.closest('input, textarea, select') !== null;
    const text = data?.getData('text/html') || data?.getData('text/plain') || '';
    if (file === undefined && (typed || text.trim() === '')) return;
    event.preventDefault();
    event.stopPropagation();
    void open(file ?? text);
  };
  const watch = new AbortController();
  const first = { capture: true, signal: watch.signal };
  document.addEventListener('drop', (event) => take(event, event.dataTransfer), first);
  document.addEventListener('paste', (event) => take(event, event.clipboardData), first);
  return () => watch.abort();
}
