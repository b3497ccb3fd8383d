import { Component, type ComponentType } from 'preact';

interface SlotProps<P> {
  /** Brings the part that stands here; asked once for each place. */
  readonly load: () => Promise<ComponentType<P>>;
  readonly with: P;
}

/** Where a part of the page stands as soon as it has come, right behind the first view. */
export class Slot<P extends object> extends Component<SlotProps<P>, { View?: ComponentType<P> }> {
  override componentDidMount() {
    void this.props.load().then((View) => this.setState({ View }));
  }

  render() {
    const { View } = this.state;
    return View && <View {...this.props.with} />;
  }
}
