import { Component } from 'preact';
import { SavedPanel } from '../saved/saved-panel.tsx';
import { ExampleList } from './example-list.tsx';

/** Frames to take up: those that manuals print, and those saved here. */
export class Shelf extends Component {
  /** Nothing here follows from the frame at hand, so that typing draws none of it again. */
  override shouldComponentUpdate() {
    return false;
  }

  render() {
    return (
      <div class="shelf">
        <ExampleList />
        <SavedPanel />
      </div>
    );
  }
}
