import { Component, type ComponentType } from 'preact';

interface SlotProps<P> {
  /** Brings the part that stands here; asked once for each place. */
  readonly load: () => Promise<ComponentType<P>>;
  readonly with: P;
}

/** What has come, so that it stands at once where it stands again. */
const come = new WeakMap<() => Promise<unknown>, unknown>();

/** Where a part of the page stands as soon as it has come, right behind the first view. */
export class Slot<P extends object> extends Component<SlotProps<P>, { View: ComponentType<P> | undefined }> {
  override componentWillMount() {
    this.setState({ View: come.get(this.props.load) as ComponentType<P> | undefined });
  }

  override componentDidMount() {
    const { load } = this.props;
    if (this.state.View) return;
    void load().then((View) => {
      come.set(load, View);
      this.setState({ View });
    });
  }

  render() {
    const { View } = this.state;
    return View && <View {...this.props.with} />;
  }
}
