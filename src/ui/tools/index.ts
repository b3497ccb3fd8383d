import './tools.css';

export { addressAid } from '../address/index.ts';
export { Explanation } from '../explanation/explanation.tsx';
export { linkLights } from '../frame/lit.ts';
export { BrokenLinkNotice } from './broken-link.tsx';
export { CopyBar } from './copy-bar.tsx';
export { Finder } from './finder.tsx';
export { ListEditor } from './list-editor.tsx';
export { ReplyPanel } from './reply-panel.tsx';
