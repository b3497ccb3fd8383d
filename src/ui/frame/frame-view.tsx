import { FrameTabs } from '../parts/frame-tabs/frame-tabs.tsx';
import { part, Slot } from '../parts/slot.tsx';
import { brokenLink, page } from '../parts/store.ts';
import { CurrentStrip } from '../parts/strip/current-strip.tsx';
import { DevicePlace } from './device/device-place.tsx';
import { Form } from './form.tsx';
import { InputPlace } from './input/input-place.tsx';
import { PrintPlace } from './tools/print-place.tsx';
import './frame.css';
import './tools/tools.css';

const brokenLinkNotice = part(
  ['brokenLink'],
  () => import('./tools/broken-link.tsx'),
  ({ BrokenLinkNotice }) => BrokenLinkNotice,
);

const BrokenLinkPlace = () => brokenLink.value && <Slot part={brokenLinkNotice} with={{}} />;

/** A frame put in or built from a form, and all that can be said of it. Its parts read what they show: typing does not draw all of it. */
export const FrameView = () => (
  <main class="frame-view">
    <BrokenLinkPlace />
    <InputPlace />
    <CurrentStrip />
    <div class="columns">
      <Form />
      <FrameTabs of={page.shown} chosen={page.tab} onChoose={page.openTab} />
    </div>
    <DevicePlace />
    <PrintPlace />
  </main>
);
