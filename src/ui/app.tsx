import { writeLink } from '../workbench/index.ts';
import { type FrameProps, FrameView } from './frame/frame-view.tsx';
import { Views } from './views.tsx';

export function App(props: FrameProps) {
  return (
    <Views frame={writeLink(props.draft, props.evaluation.controls)}>
      <FrameView {...props} />
    </Views>
  );
}
