import { defaultRules, defaultSettings, type LinkSettings, type TransactionRules } from '../../bus/index.ts';
import { Remembered } from '../tools/remembered.ts';

/** What is stored, taken over value by value where it is of the kind that the usual one is. */
function like<T extends object>(usual: T, stored: unknown): T {
  const known = (stored ?? {}) as Partial<Record<keyof T, unknown>>;
  const pairs = Object.entries(usual).map(([name, value]) => {
    const one = known[name as keyof T];
    return [name, typeof one === typeof value ? one : value];
  });
  return Object.fromEntries(pairs) as T;
}

/** How a port is opened, as chosen last. */
export const settingsMemory = new Remembered<LinkSettings>('bus-settings', defaultSettings, (stored) =>
  like(defaultSettings, stored),
);

/** How transactions are carried out, as chosen last. */
export const rulesMemory = new Remembered<TransactionRules>('bus-rules', defaultRules, (stored) =>
  like(defaultRules, stored),
);
