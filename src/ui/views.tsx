import type { ComponentChildren } from 'preact';
import { views } from '../words/index.ts';
import { REFERENCE } from './reference/address.ts';
import { reference } from './reference/lazy.tsx';
import './views.css';

interface ViewsProps {
  /** Whether the reference is open, else the Frame view. */
  readonly inReference: boolean;
  /** The address of the frame at hand. */
  readonly frame: string;
  readonly children: ComponentChildren;
}

/** The header, and the view that the address names. */
export function Views({ inReference, frame, children }: ViewsProps) {
  const link = (name: string, address: string, current: boolean) => (
    <a href={address} aria-current={current ? 'page' : undefined}>
      {name}
    </a>
  );
  return (
    <>
      <header>
        <h1>Framewright</h1>
        <nav aria-label={views.views}>
          {link(views.frame, `#${frame}`, !inReference)}
          {link(views.reference, REFERENCE, inReference)}
        </nav>
      </header>
      {inReference ? reference.value : children}
    </>
  );
}
