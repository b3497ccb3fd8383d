// From a keystroke to the repainted explanation of the longest frame, in Chromium, at full speed and with the processor
// throttled to a quarter. Frames are drawn as soon as they can be: waiting for a screen would be measured, not the page.
import { execFileSync } from 'node:child_process';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { findInstalledBrowser } from '../scripts/find-browser.mjs';
import { keystrokes } from './keystrokes.mjs';
import { quantile } from './quantile.mjs';

const WARM_UP = 15;
const KEYSTROKES = 80;
const TARGETS = new Map([
  [1, 16],
  [4, 50],
]);

const registers = Array.from({ length: 123 }, (_, index) => 1000 + index).join(' ');
const link = `#rtu/request?unitId=1&functionCode=16&startAddress=100&registers=${registers}`;

execFileSync('npm', ['run', 'build'], { stdio: 'ignore', shell: process.platform === 'win32' });
const server = await preview({ preview: { port: 43927, host: '127.0.0.1' }, logLevel: 'silent' });
const executablePath = findInstalledBrowser();
const browser = await chromium.launch({
  ...(executablePath && { executablePath }),
  args: [
    ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
    '--disable-background-networking',
    '--disable-frame-rate-limit',
    '--disable-gpu-vsync',
    '--disable-features=WebUIOmniboxPopup,WebUIOmniboxAimPopup',
  ],
});

const cases = [
  ['Unit (slave address)', 'one line and the CRC change', ['2', 'Backspace']],
  ['Start address', 'every register line changes', ['1', 'Backspace']],
  ['Registers', 'the last register and the CRC change', ['1', 'Backspace']],
];

console.log('From a keystroke to the repainted explanation of a frame of 255 bytes, milliseconds');
let met = true;
for (const [rate, target] of TARGETS) {
  console.log(
    `\n${rate === 1 ? 'Full speed' : `Processor throttled ${rate}×`}, target ${target} at the 95th percentile`,
  );
  for (const [label, what, keys] of cases) {
    const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
    await page.goto(`http://127.0.0.1:43927/${link}`);
    await page.getByRole('button', { name: /^Copy / }).waitFor();
    const session = await page.context().newCDPSession(page);
    await session.send('Emulation.setCPUThrottlingRate', { rate });
    const times = (await keystrokes(page, label, keys, WARM_UP + KEYSTROKES)).slice(WARM_UP).sort((a, b) => a - b);
    // The fastest tenth says what the page takes where nothing else runs.
    const [undisturbed, median, high] = [0.1, 0.5, 0.95].map((share) => quantile(times, share));
    met &&= high <= target;
    const row = [
      label.padEnd(24),
      what.padEnd(40),
      `undisturbed ${undisturbed.toFixed(1)}`.padEnd(20),
      `median ${median.toFixed(1)}`.padEnd(14),
      `95 % ${high.toFixed(1)}`,
    ];
    console.log(`  ${row.join('')}${high <= target ? '' : '  NOT MET'}`);
    await page.close();
  }
}
await browser.close();
await server.close();
console.log(met ? '\nEvery target met' : '\nNot every target met');
process.exit(0);
