export { bus } from './bus.ts';
export { FollowingPanel } from './following-panel.ts';
export { pollMemory, scanMemory } from './memories.ts';
export { NumberField } from './settings-form.tsx';
