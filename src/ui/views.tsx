import { busStatus, busView } from './bus/view.ts';
import { checksumView } from './checksum/view.ts';
import { frameView } from './frame/view.ts';
import { busLink } from './parts/bus-link.ts';
import { useKeyOf } from './parts/commands.ts';
import { devicesWanted } from './parts/device/naming.ts';
import { offered, pasted } from './parts/pasted.ts';
import { part, Slot } from './parts/slot.tsx';
import { commands, page } from './parts/store.ts';
import type { View } from './parts/view.ts';
import { useWords } from './parts/words.ts';
import { referenceView } from './reference/view.ts';
import { timingView } from './timing/view.ts';
import './views.css';

const views: readonly View[] = [frameView, checksumView, timingView, busView, referenceView];

/** The words of the view that is open. */
export const openWords = () => views.find(({ id }) => id === (page.view.peek() ?? 'frame'))?.part.words ?? [];

/** The header, and the view that the address names. */
export function Views() {
  const words = useWords('page').views;
  const open = page.view.value ?? 'frame';
  return (
    <>
      <header>
        <h1>Framewright</h1>
        <nav aria-label={words.views}>
          {views.map(({ id }) => (
            <ViewLink key={id} id={id} name={words.names[id]} />
          ))}
        </nav>
        <BusStatus />
      </header>
      <KeysPlace />
      <ReaderPlace />
      <PasteOfferPlace />
      <ChosenDevicePlace />
      {views.map(({ id, part }) => id === open && <Slot key={id} part={part} with={{}} />)}
    </>
  );
}

/** The way to a view; to the Frame view with its current frame. */
const ViewLink = ({ id, name }: { readonly id: View['id']; readonly name: string }) => (
  <a
    href={`#${id === 'frame' ? page.link.value : id}`}
    aria-current={(page.view.value ?? 'frame') === id ? 'page' : undefined}
    {...useKeyOf(`view-${id}`)}
  >
    {name}
  </a>
);

const keyList = part(
  ['commands'],
  () => import('./parts/key-list.tsx'),
  ({ KeyList }) => KeyList,
);

const KeysPlace = () => commands.listed.value && <Slot part={keyList} with={{}} />;

const reader = part(
  [],
  () => import('./parts/reader.ts'),
  ({ Reader }) => Reader,
);

const chosenDevice = part(
  ['devices'],
  () => import('./parts/device/chosen.ts'),
  ({ ChosenDevice }) => ChosenDevice,
);

/** A device that is chosen names what is in a frame, whatever view is open. */
const ChosenDevicePlace = () => devicesWanted.value && <Slot part={chosenDevice} with={{}} />;

const pasteOffer = part(
  ['paste'],
  () => import('./parts/paste-offer.tsx'),
  ({ PasteOffer }) => PasteOffer,
);

const PasteOfferPlace = () => offered.value && <Slot part={pasteOffer} with={{}} />;

/** What is pasted is read whatever view is open. */
const ReaderPlace = () => pasted.wanted.value && <Slot part={reader} with={{}} />;

const BusStatus = () => busLink.value.kind !== 'closed' && <Slot part={busStatus} with={{}} />;
