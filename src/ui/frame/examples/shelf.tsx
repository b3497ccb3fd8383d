import { Component } from 'preact';
import { SavedPanel } from '../saved/saved-panel.tsx';
import { ExampleList } from './example-list.tsx';

/** Frames to take up: those that manuals print, and those saved here. */
export class Shelf extends Component {
  /** The same element each time: examples do not follow from the current frame, and typing draws none of them again. */
  private readonly examples = <ExampleList />;

  render() {
    return (
      <div class="shelf">
        {this.examples}
        <SavedPanel />
      </div>
    );
  }
}
