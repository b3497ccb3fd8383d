import './wire.css';
import { KeptChoice } from '../../../store/index.ts';
import { type Draft, type Evaluation, flag } from '../../../workbench/index.ts';
import { DrawnWhenSeen } from '../../kit/drawn-when-seen.ts';
import { Slot } from '../../parts/slot.tsx';
import { storage } from '../../state/draft.ts';
import { loadWords, wireWords as words } from './wire-words.ts';

export { loadWords };

interface PanelProps {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

const isOpen = new KeptChoice(storage, 'wire', false, flag);

const loadView = () => import('./wire-view.tsx').then(({ WireView }) => WireView);

/** The frame as its line carries it, once it is opened. */
export class WirePanel extends DrawnWhenSeen<PanelProps, HTMLDetailsElement, { open: boolean }> {
  override state = { open: isOpen.value };

  render() {
    const { draft, frame } = this.props;
    const { open } = this.state;
    return (
      <details
        ref={this.element}
        class="panel wire"
        open={open}
        onToggle={({ currentTarget, target }) => {
          if (target !== currentTarget) return;
          isOpen.value = currentTarget.open;
          this.setState({ open: currentTarget.open });
        }}
      >
        <summary>
          <h2>{words.title}</h2> <span class="said">{words.intro}</span>
        </summary>
        {open && (frame ? <Slot load={loadView} with={{ draft, frame }} /> : <p>{words.noFrame}</p>)}
      </details>
    );
  }
}
