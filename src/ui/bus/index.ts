export { type BusState, bus, type JobListener } from './bus.ts';
export { FollowingPanel } from './following-panel.ts';
export { busWords } from './language.ts';
export { pollMemory, scanMemory } from './memories.ts';
export { type JobEnd, runningJob } from './running-job.ts';
export { NumberField } from './settings-form.tsx';
