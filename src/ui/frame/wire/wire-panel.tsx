import './wire.css';
import { KeptChoice } from '../../../store/index.ts';
import { type Draft, type Evaluation, flag } from '../../../workbench/index.ts';
import { DrawnWhenSeen } from '../../kit/drawn-when-seen.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { Slot } from '../../parts/slot.tsx';
import { storage } from '../../parts/store.ts';
import { loadWords, wireWords as words } from './wire-words.ts';

export { loadWords };

interface PanelProps {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

const isOpen = new KeptChoice(storage, 'wire', false, flag);

const loadView = () => import('./wire-view.tsx').then(({ WireView }) => WireView);

/** The frame as its line carries it, once it is opened. */
export class WirePanel extends DrawnWhenSeen<PanelProps, HTMLDetailsElement> {
  render() {
    const { draft, frame } = this.props;
    return (
      <FoldPanel
        root={this.element}
        class="wire"
        title={words.title}
        hint={words.intro}
        open={isOpen.value}
        onToggle={(open) => {
          isOpen.value = open;
        }}
      >
        {() => (frame ? <Slot part={loadView} with={{ draft, frame }} /> : <p>{words.noFrame}</p>)}
      </FoldPanel>
    );
  }
}
