import { effect } from '@preact/signals-core';
import { render } from 'preact';
import { App } from './app.tsx';
import { linkLights } from './frame/lit.ts';
import { complaints, fetchComplaints } from './language.ts';
import { brokenLink, draft, evaluation, follow, takeAddress } from './state.ts';
import './style.css';

takeAddress();
addEventListener('popstate', takeAddress);
addEventListener('hashchange', takeAddress);
addEventListener('pagehide', follow);

const root = document.getElementById('app');
if (root) {
  effect(() => {
    // Sentences that come later are a reason to draw again.
    complaints.value;
    render(<App draft={draft.value} evaluation={evaluation.value} broken={brokenLink.value} />, root);
  });
  linkLights(root);
}
void fetchComplaints();
