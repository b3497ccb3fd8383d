import { Component } from 'preact';
import type { CatalogueCrc } from '../../modbus/index.ts';
import { Slot } from '../parts/slot.tsx';
import { checksumWords as words } from './checksum-words.ts';
import { Folded } from './remembered-fold.tsx';
import { loadSteps } from './steps/load-steps.ts';

/** What the step view is given: the bytes, and the algorithm that goes over them. */
export interface StepsProps {
  readonly bytes: Uint8Array;
  readonly algorithm: CatalogueCrc;
}

/** Where the step view stands, folded. It is loaded right behind this view, so that opening it costs its drawing alone. */
export class StepsPlace extends Component<StepsProps> {
  override componentDidMount() {
    void loadSteps();
  }

  render() {
    return (
      <Folded name="checksum-steps" title={words.steps} hint={words.stepsHint}>
        {() => <Slot part={loadSteps} with={this.props} />}
      </Folded>
    );
  }
}
