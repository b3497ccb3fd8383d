import { computed } from '@preact/signals';
import { Programs } from '../../../store/index.ts';
import { device } from '../device/naming.ts';
import { line } from '../line.ts';
import { page, storage } from '../store.ts';

/** Which program is written in this page, and how: for the device that is chosen and the line as it is set. */
export const programs = new Programs(
  page,
  storage,
  computed(() => ({ profile: device.value, line: line.setting.value })),
);
