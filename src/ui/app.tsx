import { FrameView } from './frame/frame-view.tsx';
import { brokenLink, draft, evaluation, page } from './state/draft.ts';
import { Views } from './views.tsx';

export function App() {
  return (
    <Views frame={page.link.value}>
      <FrameView draft={draft.value} evaluation={evaluation.value} broken={brokenLink.value} />
    </Views>
  );
}
