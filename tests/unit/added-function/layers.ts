/** What the test of an added function uses, built anew with that function. */
export * as bus from '../../../src/bus/index.ts';
export { makePlan } from '../../../src/codegen/make-plan.ts';
export { settingsOf } from '../../../src/codegen/settings.ts';
export * as devices from '../../../src/devices/index.ts';
export * as diagnosis from '../../../src/diagnosis/index.ts';
export * as modbus from '../../../src/modbus/index.ts';
export * as sequences from '../../../src/sequences/index.ts';
export * as workbench from '../../../src/workbench/index.ts';
