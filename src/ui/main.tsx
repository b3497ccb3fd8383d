import { render } from 'preact';
import { App } from './app.tsx';
import { drawWith } from './state/cell.ts';
import { brokenLink, draft, evaluation, follow, takeAddress } from './state/draft.ts';
import './style.css';

takeAddress();
addEventListener('popstate', takeAddress);
addEventListener('hashchange', takeAddress);
addEventListener('pagehide', follow);

const root = document.getElementById('app');
if (root) {
  drawWith(() => {
    render(<App draft={draft.value} evaluation={evaluation.value} broken={brokenLink.value} />, root);
  });
}
