import { useLayoutEffect, useRef } from 'preact/hooks';
import { useCommand } from './commands.ts';
import './paste-offer.css';
import { offered, pasted } from './pasted.ts';
import { useWords } from './words.ts';

/** Offers to read what was pasted into a field for a number, at the field. It is gone when the focus leaves it. */
export function PasteOffer() {
  const words = useWords('paste');
  const button = useRef<HTMLButtonElement>(null);
  const { value: offer } = offered;
  useLayoutEffect(() => button.current?.focus({ preventScroll: true }), [offer]);
  const end = () => {
    offered.value = undefined;
  };
  useCommand(
    'close',
    offer &&
      (() => {
        end();
        offer.field.focus();
      }),
  );
  if (offer === undefined) return null;
  const { left, bottom } = offer.field.getBoundingClientRect();
  return (
    <div class="paste-offer" style={{ left: `${left + scrollX}px`, top: `${bottom + scrollY}px` }}>
      <button
        ref={button}
        type="button"
        class="first"
        onBlur={end}
        onClick={() => {
          end();
          pasted.take(offer.text);
        }}
      >
        {words.readAsFrame}
      </button>
    </div>
  );
}
