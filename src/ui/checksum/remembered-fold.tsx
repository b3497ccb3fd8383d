import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { KeptChoice } from '../../store/index.ts';
import { flag } from '../../workbench/index.ts';
import { FoldPanel } from '../kit/fold.tsx';
import { storage } from '../parts/store.ts';

interface FoldedProps {
  /** The name it is remembered by, and its class. */
  readonly name: string;
  readonly title: string;
  readonly hint: string;
  /** Whether the address has something in it, so that it is open at first whatever is remembered. */
  readonly filled?: boolean;
  /** Makes what it holds when it is opened. */
  readonly children: () => ComponentChildren;
}

/** A part of the view that is folded away until it is wanted; whether it is open is remembered. */
export function Folded({ name, filled, ...panel }: FoldedProps) {
  const [remembered] = useState(() => new KeptChoice(storage, name, false, flag, 'tab'));
  const [open] = useState(() => filled || remembered.value);
  return (
    <FoldPanel
      {...panel}
      class={name}
      open={open}
      onToggle={(next) => {
        remembered.value = next;
      }}
    />
  );
}
