import type { SerialMode } from '../../../modbus/index.ts';
import { KeptChoice } from '../../../store/index.ts';
import {
  firstLine,
  type LineChoice,
  type LineMemory,
  lineChoice,
  storedLine,
  withLine,
} from '../../../workbench/index.ts';
import { device } from '../../parts/device/naming.ts';
import { storage } from '../../parts/store.ts';

const remembered = new KeptChoice<LineMemory>(storage, 'wire-line', firstLine, storedLine);

/** How the line is set for the device that is chosen. */
export const currentLine = (mode: SerialMode): LineChoice => lineChoice(remembered.value, mode, device.value);

/** Sets something of the line, and remembers it for the device that is chosen. */
export function setLine(mode: SerialMode, changed: Partial<Omit<LineChoice, 'device'>>): void {
  remembered.value = withLine(remembered.value, mode, device.value, changed);
}
