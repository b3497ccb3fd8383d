import { render } from 'preact';
import { App } from './app.tsx';
import { page } from './state/draft.ts';
import './style.css';

const take = () => page.address.take();
addEventListener('popstate', take);
addEventListener('hashchange', take);
addEventListener('pagehide', () => page.address.now());

const root = document.getElementById('app');
if (root) {
  // What the page says while its script is on its way.
  root.replaceChildren();
  render(<App />, root);
}
