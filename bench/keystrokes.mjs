/**
 * Types into a field; answers the milliseconds from each keystroke's own time to the first task after the frame that shows it.
 * @param {import('@playwright/test').Page} page
 * @param {string | import('@playwright/test').Locator} field a label, or what is found
 * @param {readonly string[]} keys typed again and again
 * @param {number} count
 * @returns {Promise<number[]>}
 */
export async function keystrokes(page, field, keys, count) {
  const input = typeof field === 'string' ? page.getByLabel(field, { exact: true }) : field;
  await input.focus();
  await page.keyboard.press('End');
  await page.evaluate(() => {
    globalThis.times = [];
    globalThis.stop = new AbortController();
    document.addEventListener(
      'input',
      (event) => {
        const from = event.timeStamp;
        requestAnimationFrame(() => {
          const { port1, port2 } = new MessageChannel();
          port1.onmessage = () => globalThis.times.push(performance.now() - from);
          port2.postMessage(undefined);
        });
      },
      { capture: true, signal: globalThis.stop.signal },
    );
  });
  for (let n = 0; n < count; n++) {
    await page.keyboard.press(keys[n % keys.length]);
    await page.waitForFunction((typed) => globalThis.times.length >= typed, n + 1);
  }
  return page.evaluate(() => {
    globalThis.stop.abort();
    return globalThis.times;
  });
}
