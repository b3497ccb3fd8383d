import { type FrameProps, FrameView } from './frame/frame-view.tsx';

export function App(props: FrameProps) {
  return (
    <>
      <header>
        <h1>Framewright</h1>
      </header>
      <FrameView {...props} />
    </>
  );
}
