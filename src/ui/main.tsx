import { render } from 'preact';

const root = document.getElementById('app');
if (root) render(<h1>Framewright</h1>, root);
