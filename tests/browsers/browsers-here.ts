import { existsSync } from 'node:fs';
import { openChromium } from './chromium.ts';
import { openFirefox } from './firefox.ts';
import type { Browser } from './tab.ts';
import { openWebKit } from './webkit.ts';

interface Found {
  readonly name: string;
  readonly start: () => Promise<Browser>;
}

/** The browsers whose programs the environment names: `FRAMEWRIGHT_BROWSER`, `FRAMEWRIGHT_FIREFOX`, `FRAMEWRIGHT_WEBKIT`. */
export function browsersHere(): readonly Found[] {
  const { FRAMEWRIGHT_BROWSER: chromium, FRAMEWRIGHT_FIREFOX: firefox, FRAMEWRIGHT_WEBKIT: webkit } = process.env;
  const [driver = '', window = ''] = webkit?.split(':') ?? [];
  return [
    ...(chromium ? [{ name: 'Chromium', start: () => openChromium(chromium) }] : []),
    ...(firefox ? [{ name: 'Firefox', start: () => openFirefox(firefox) }] : []),
    ...(existsSync(driver) && existsSync(window)
      ? [{ name: 'WebKitGTK', start: () => openWebKit(driver, window) }]
      : []),
  ];
}
