import { signal } from '@preact/signals';
import { currentFrame } from '../parts/current-frame.ts';
import { type FrameTab, FrameTabs } from '../parts/frame-tabs/frame-tabs.tsx';
import { CurrentStrip } from '../parts/strip/current-strip.tsx';
import { Below } from './below.tsx';
import { Form } from './form.tsx';
import { InputPlace } from './input/input-place.tsx';
import { FindingsPlace } from './read/read-place.tsx';
import { BrokenLinkNotice } from './tools/broken-link.tsx';
import './frame.css';
import './tools/tools.css';

/** The tab that is open. */
const openTab = signal<FrameTab>('bytes');

/** A frame put in or built from a form, and all that can be said of it. Its parts read what they show: typing does not draw all of it. */
export const FrameView = () => (
  <main class="frame-view">
    <BrokenLinkNotice />
    <InputPlace />
    <CurrentStrip />
    <FindingsPlace />
    <div class="columns">
      <Form />
      <FrameTabs of={currentFrame} chosen={openTab} />
    </div>
    <Below />
  </main>
);
