import { test as base, expect } from '@playwright/test';

/** Playwright's test, whose page must print no warning and no error, throw nothing, miss no file, and break no line of its policy. */
export const test = base.extend({
  page: async ({ page }, use) => {
    const complaints: string[] = [];
    page.on('console', (message) => {
      if (message.type() === 'warning' || message.type() === 'error') {
        complaints.push(`console ${message.type()}: ${message.text()}`);
      }
    });
    page.on('pageerror', (error) => complaints.push(`thrown: ${error.message}`));
    page.on('requestfailed', (request) => {
      // What a reload breaks off is not missing.
      const why = request.failure()?.errorText;
      if (why !== 'net::ERR_ABORTED') complaints.push(`failed: ${request.url()} ${why}`);
    });
    page.on('response', (response) => {
      if (response.status() >= 400) complaints.push(`${response.status()}: ${response.url()}`);
    });
    await page.exposeFunction('policyBroken', (what: string) => complaints.push(`against the policy: ${what}`));
    await page.addInitScript(() => {
      addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI, sourceFile }) => {
        const tell = (globalThis as unknown as { policyBroken(what: string): void }).policyBroken;
        tell(`${effectiveDirective} ${blockedURI} ${sourceFile}`);
      });
    });
    await use(page);
    expect(complaints, 'what the page complained of').toEqual([]);
  },
});

export { expect } from '@playwright/test';
