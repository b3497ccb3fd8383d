export { type BusState, bus } from './bus.ts';
export { NumberField } from './settings-form.tsx';
