import './tools.css';

export { Explanation } from '../../parts/explanation/explanation.tsx';
export { addressAid } from '../address/index.ts';
export { linkLights } from '../lit.ts';
export { BrokenLinkNotice } from './broken-link.tsx';
export { CopyBar } from './copy-bar.tsx';
export { Finder } from './finder.tsx';
export { ListEditor } from './list-editor.tsx';
export { ReplyPanel } from './reply-panel.tsx';
