import { Component } from 'preact';
import type { ShelfViews } from './index.ts';

/** Where a part of the shelf stands as soon as it has come, right behind the first view. */
export class ShelfSlot extends Component<{ part: keyof ShelfViews }, { views?: ShelfViews }> {
  override componentDidMount() {
    void import('./index.ts').then(async ({ loadViews }) => this.setState({ views: await loadViews() }));
  }

  render() {
    const View = this.state.views?.[this.props.part];
    return View && <View />;
  }
}
