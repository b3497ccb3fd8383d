import { type BrowserContext, test as base, expect, type Page, type Request } from '@playwright/test';

/**
 * Playwright's test, whose pages must print no warning and no error, throw nothing, miss no file, and break no line of
 * their policy, but for what the test names with `test.use({ expected: / … / })`. Pages share a context, which Playwright
 * empties between tests.
 */
export const test = base.extend<{ expected: RegExp; watch(context: BrowserContext): Promise<void> }>({
  expected: [/$^/, { option: true }],
  watch: async ({ expected }, use) => {
    const complaints: string[] = [];
    await use((context) => watch(context, complaints));
    const others = complaints.filter((complaint) => !expected.test(complaint));
    expect(others, 'what the page complained of').toEqual([]);
  },
  context: async ({ context, watch }, use) => {
    await watch(context);
    await use(context);
  },
});

/** Writes down what the pages of a context complain of. */
export async function watch(context: BrowserContext, complaints: string[]): Promise<void> {
  context.on('console', (message) => {
    // What Playwright says where a test allows no service worker.
    if (message.text() === 'Service Worker registration blocked by Playwright') return;
    if (message.type() === 'warning' || message.type() === 'error') {
      complaints.push(`console ${message.type()}: ${message.text()}`);
    }
  });
  context.on('weberror', (error) => complaints.push(`thrown: ${error.error().message}`));
  const awaited = new Set<Request>();
  awaitedIn.set(context, awaited);
  context.on('request', (request) => awaited.add(request));
  context.on('requestfinished', (request) => awaited.delete(request));
  context.on('requestfailed', (request) => {
    awaited.delete(request);
    // What a reload breaks off is not missing.
    const why = request.failure()?.errorText;
    if (why !== 'net::ERR_ABORTED') complaints.push(`failed: ${request.url()} ${why}`);
  });
  context.on('response', (response) => {
    if (response.status() >= 400) complaints.push(`${response.status()}: ${response.url()}`);
  });
  await context.exposeFunction('policyBroken', (what: string) => complaints.push(`against the policy: ${what}`));
  await context.addInitScript(() => {
    addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI, sourceFile }) => {
      const tell = (globalThis as unknown as { policyBroken(what: string): void }).policyBroken;
      tell(`${effectiveDirective} ${blockedURI} ${sourceFile}`);
    });
  });
}

/** What the pages of a context have asked for and not got yet. */
const awaitedIn = new WeakMap<BrowserContext, ReadonlySet<Request>>();

/** So often it is looked whether all came: of what a worker or a page asks that ends, the browser may never tell. */
const LOOKS = 100;

/**
 * Waits until the page has drawn what was done to it, and until all has come that it asks for then, and that this asks for in turn.
 * Playwright's wait for an idle network ends at once when the network has been idle before.
 */
export async function allCame(page: Page): Promise<void> {
  const drawn = () =>
    page.evaluate(
      () =>
        new Promise<void>((resolve) => {
          const idle = () => requestIdleCallback(() => setTimeout(resolve), { timeout: 1000 });
          requestAnimationFrame(() => requestAnimationFrame(idle));
          // A page behind another one is not drawn.
          setTimeout(resolve, 2000);
        }),
    );
  await drawn();
  for (let look = 0; look < LOOKS && (awaitedIn.get(page.context())?.size ?? 0) > 0; look++) await drawn();
}

export { expect } from '@playwright/test';
