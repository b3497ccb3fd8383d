import type { LinkSettings } from '../bus/index.ts';
import { firstPort, readPortSettings } from '../workbench/index.ts';
import type { Line } from './line.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** How a port is opened: with the line that the whole page has, and with what only a port needs, which is kept here. */
export function portSettings(line: Line, storage: PageStorage): { value: LinkSettings } {
  // What a tab works with is its own: its session is in the midst of it.
  const port = new KeptChoice(storage, 'bus-settings', firstPort, readPortSettings, 'tab');
  return {
    get value() {
      return { ...line.setting.value, ...port.value };
    },
    set value({ flowControl, bufferSize, ...setting }) {
      port.value = { flowControl, bufferSize };
      line.set(setting);
    },
  };
}
