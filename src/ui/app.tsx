import { FrameView } from './frame/frame-view.tsx';
import { Views } from './views.tsx';

export const App = () => (
  <Views>
    <FrameView />
  </Views>
);
