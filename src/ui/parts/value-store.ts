import { computed } from '@preact/signals';
import { Values } from '../../store/index.ts';
import { targetsOf } from '../../workbench/index.ts';
import { device } from './device/naming.ts';
import { evaluation, storage } from './store.ts';

/** How values are looked at and written in this page. */
export const valueStore = new Values(storage, device);

/** The field of the form that typed values are put into. */
export const currentTarget = computed(() => {
  const targets = targetsOf(evaluation.value);
  return targets.find(({ path }) => path === valueStore.into.value) ?? targets[0];
});
