import { effect } from '@preact/signals';
import type { RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { firstDraft, frameBeginning } from '../workbench/index.ts';
import { busView } from './bus/view.ts';
import { checksumView } from './checksum/view.ts';
import { devicesView } from './devices/view.ts';
import { frameView } from './frame/view.ts';
import { useKeyOf } from './parts/commands.ts';
import { devicesWanted } from './parts/device/naming.ts';
import { Settings, ThemeChoice } from './parts/header/header.tsx';
import { offered, pasted } from './parts/pasted.ts';
import { part, Slot } from './parts/slot.tsx';
import { commands, page, viewTitle } from './parts/store.ts';
import type { View } from './parts/view.ts';
import { useWords } from './parts/words.ts';
import { referenceView } from './reference/view.ts';
import { timingView } from './timing/view.ts';
import { logView } from './trace/view.ts';
import './views.css';

const views: readonly View[] = [frameView, logView, busView, devicesView, checksumView, timingView, referenceView];

/** The words of the view that is open. */
export const openWords = () => views.find(({ id }) => id === (page.view.peek() ?? 'frame'))?.part.words ?? [];

/** The header, and the view that the address names. */
export function Views() {
  const words = useWords('page').views;
  const open = page.view.value ?? 'frame';
  const content = useRef<HTMLDivElement>(null);
  useTitle();
  useLeaving(content);
  return (
    <>
      <header>
        <button type="button" class="skip" onClick={() => content.current?.focus()}>
          {words.skip}
        </button>
        <div class="header-line">
          <h1>Framewright</h1>
          <nav aria-label={words.views}>
            {views.map(({ id }) => (
              <ViewLink key={id} id={id} name={words.names[id]} />
            ))}
          </nav>
          <Settings />
          <ThemeChoice />
        </div>
      </header>
      <KeysPlace />
      <ReaderPlace />
      <PasteOfferPlace />
      <ChosenDevicePlace />
      <div id="content" ref={content} tabIndex={-1}>
        {views.map(({ id, part }) => id === open && <Slot key={id} part={part} with={{}} />)}
      </div>
    </>
  );
}

/** A view that is opened begins at its top, but the Frame view where it was left, if the frame is still the same. */
function useLeaving(content: RefObject<HTMLElement | null>): void {
  const open = page.view.value;
  const left = useRef({ link: '', top: 0 });
  const was = useRef(open);
  useLayoutEffect(
    () =>
      page.view.subscribe((view) => {
        if (view !== undefined && was.current === undefined) left.current = { link: page.link.peek(), top: scrollY };
      }),
    [],
  );
  useLayoutEffect(() => {
    if (was.current === open) return;
    was.current = open;
    scrollTo(0, open === undefined && left.current.link === page.link.peek() ? left.current.top : 0);
    // What had the focus may be gone with its view.
    if (document.activeElement === document.body) content.current?.focus({ preventScroll: true });
  }, [open]);
}

/** Lets the window have the title of the view, or the beginning of the frame that is shown. */
function useTitle(): void {
  const words = useWords('page').views;
  useLayoutEffect(
    () =>
      effect(() => {
        const { frame } = page.evaluation.value;
        const isFirst = page.draft.value === firstDraft || frame === undefined;
        const ofFrame = isFirst ? words.title : words.frameTitle(frameBeginning(frame.reading, frame.bytes));
        document.title = viewTitle.value ?? ofFrame;
      }),
    [words],
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
