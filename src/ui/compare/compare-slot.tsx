import { Component } from 'preact';
import { ComparePanel } from './compare-panel.tsx';
import type { CompareProps } from './compared.ts';
import { loadWords } from './language.ts';

/** Where the comparison stands as soon as its words have come, behind the other tools. */
export class CompareSlot extends Component<CompareProps, { readonly ready?: true }> {
  override componentDidMount() {
    void loadWords().then(() => this.setState({ ready: true }));
  }

  render() {
    return this.state.ready && <ComparePanel {...this.props} />;
  }
}
