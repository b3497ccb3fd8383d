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

/** The header, and the view that the address names. */
export function Views({ children }: { readonly children: ComponentChildren }) {
  const open = page.view.value;
  return (
    <>
      <header>
        <h1>Framewright</h1>
        <nav aria-label={views.views}>
          <FrameLink />
          {otherViews.map((view) => (
            <a key={view} href={`#${view}`} aria-current={open === view ? 'page' : undefined}>
              {views.names[view]}
            </a>
          ))}
        </nav>
        <BusStatus />
      </header>
      <Slot load={loadBehind} with={{}} />
      {open ? <Slot key={open} load={loaders[open]} with={{}} /> : children}
    </>
  );
}

/** The way to the current frame, from any view. */
const FrameLink = () => (
  <a href={`#${page.link.value}`} aria-current={page.view.value === undefined ? 'page' : undefined}>
    {views.names.frame}
  </a>
);

const BusStatus = () => busStatus.value && <small role="status">{busStatus.value}</small>;
