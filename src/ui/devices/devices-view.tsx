import { useLayoutEffect, useMemo, useState } from 'preact/hooks';
import { AddressedView, MapImport } from '../../store/index.ts';
import { FileButton } from '../kit/file-button.tsx';
import { Messages } from '../kit/messages.tsx';
import { allDevices, ChosenDevice } from '../parts/device/chosen.ts';
import { DevicePanel } from '../parts/device-panel/device-panel.tsx';
import { part, Slot } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { useView } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import './devices-view.css';
import { Library } from './library.tsx';
import { MapComparison } from './map-comparison.tsx';

const assistant = part(
  ['library', 'registerMaps', 'devices'],
  () => import('./import-assistant.tsx'),
  ({ ImportAssistant }) => ImportAssistant,
);

/** Bytes of a file of which nobody makes a register map. */
const LARGEST = 50_000_000;

/** All profiles, the map of the chosen one, and the import of maps of any maker. */
export function DevicesView() {
  const words = useWords('library');
  const mapImport = useMemo(() => new MapImport(allDevices), []);
  const [said, say] = useState('');
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
    if (typeof what === 'string') return mapImport.open({ name: words.pastedName, content: what });
    if (what.size > LARGEST) return say(words.tooBig);
    say(words.reading(what.name));
    const content = await what.arrayBuffer().catch(() => undefined);
    if (content === undefined) return say(words.unread);
    say('');
    mapImport.open({ name: what.name, content: new Uint8Array(content) });
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
