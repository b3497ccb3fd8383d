import { Strip } from '../parts/strip/strip.tsx';
import { Below } from './below.tsx';
import { Form } from './form.tsx';
import { FrameTabs } from './frame-tabs.tsx';
import { InputPlace } from './input/input-place.tsx';
import { FindingsPlace } from './read/read-place.tsx';
import { BrokenLinkNotice } from './tools/broken-link.tsx';
import './frame.css';
import './tools/tools.css';

/** A frame put in or built from a form, and all that can be said of it. Its parts read what they show: typing does not draw all of it. */
export const FrameView = () => (
  <main>
    <BrokenLinkNotice />
    <InputPlace />
    <Strip />
    <FindingsPlace />
    <div class="columns">
      <Form />
      <FrameTabs />
    </div>
    <Below />
  </main>
);
