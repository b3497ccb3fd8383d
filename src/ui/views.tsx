import type { ComponentChildren, ComponentType } from 'preact';
import { type OtherView, otherViews } from '../store/index.ts';
import { views } from '../words/index.ts';
import { loadBehind } from './frame/behind.ts';
import { Slot } from './parts/slot.tsx';
import { busStatus } from './state/bus-status.ts';
import { page } from './state/draft.ts';
import './views.css';

/** What brings a view and its words, when it is first opened. */
const loaders: Readonly<Record<OtherView, () => Promise<ComponentType>>> = {
  bus: () => import('./bus/bus-view.tsx').then(({ load }) => load()),
  reference: () => import('./reference/reference-view.tsx').then(({ load }) => load()),
  timing: () => import('./timing/timing-view.tsx').then(({ load }) => load()),
  checksum: () => import('./checksum/checksum-view.tsx').then(({ load }) => load()),
};

interface ViewsProps {
  /** The address of the frame at hand. */
  readonly frame: string;
  readonly children: ComponentChildren;
}

/** The header, and the view that the address names. */
export function Views({ frame, children }: ViewsProps) {
  const open = page.view.value;
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
          {link(views.names.frame, `#${frame}`, open === undefined)}
          {otherViews.map((view) => link(views.names[view], `#${view}`, open === view))}
        </nav>
        {busStatus.value && <small role="status">{busStatus.value}</small>}
      </header>
      <Slot load={loadBehind} with={{}} />
      {open ? <Slot key={open} load={loaders[open]} with={{}} /> : children}
    </>
  );
}
