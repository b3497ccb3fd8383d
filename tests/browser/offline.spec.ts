import type { Page } from '@playwright/test';
import { languages } from '#known';
import { everyView } from './every-view.ts';
import { FrameForm } from './form.ts';
import { allCame, test as base, expect } from './page.ts';
import { type Broken, PageServer } from './page-server.ts';

const words = await languages.en.offline();
const input = await languages.en.input();

const test = base.extend<{ server: PageServer; address: string }>({
  server: async ({ browserName: _ }, use) => {
    const server = new PageServer();
    await use(server);
    server.stop();
  },
  address: ({ server }, use) => server.start().then(use),
});

test.use({ serviceWorkers: 'allow' });

const offer = (page: Page) => page.getByRole('region', { name: words.newVersion });
const expectVersion = (page: Page, which: string) =>
  expect(page.locator(`html[data-version="${which}"]`)).toHaveCount(1);

/** Waits until the browser keeps the page. */
const kept = (page: Page) =>
  page.evaluate(
    () =>
      new Promise<void>((resolve) => {
        if (navigator.serviceWorker.controller) resolve();
        else navigator.serviceWorker.addEventListener('controllerchange', () => resolve());
      }),
  );

/** Has the browser look for a new version, as it does when the page is opened; how that ended. */
const update = (page: Page) =>
  page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    await registration.update();
    const worker = registration.installing ?? registration.waiting;
    while (worker?.state === 'installing') {
      await new Promise((resolve) => worker.addEventListener('statechange', resolve, { once: true }));
    }
    return worker?.state;
  });

test('after one visit to the first view the page can be installed, takes what is shared and opened, and every view works offline', async ({
  page,
  context,
  address,
  server,
}) => {
  await page.addInitScript(() => {
    if (location.protocol === 'about:') return;
    // The page can be used before the browser begins to keep it.
    const { register } = ServiceWorkerContainer.prototype;
    ServiceWorkerContainer.prototype.register = function (...given) {
      document.documentElement.toggleAttribute('data-usable', document.querySelector('form input') !== null);
      return register.apply(this, given);
    };
    const launchQueue = { setConsumer: (take: unknown) => Object.assign(window, { launch: take }) };
    Object.defineProperty(window, 'launchQueue', { value: launchQueue });
  });
  await page.goto(address);
  await kept(page);
  await expect(page.locator('html[data-usable]')).toHaveCount(1);
  const files = await page.evaluate(async () => {
    const [name = ''] = await caches.keys();
    const keys = await (await caches.open(name)).keys();
    return keys.map(({ url }) => new URL(url).pathname.slice(1) || 'index.html');
  });
  expect(files.sort()).toEqual(server.files.sort());

  await test.step('the page can be installed, with icons of the sizes that its manifest says', async () => {
    const session = await context.newCDPSession(page);
    const { errors } = await session.send('Page.getAppManifest');
    expect(errors).toEqual([]);
    const { installabilityErrors } = await session.send('Page.getInstallabilityErrors');
    expect(installabilityErrors).toEqual([]);
    const sizes = await page.evaluate(async () => {
      const { icons } = (await (await fetch('./app.webmanifest')).json()) as {
        icons: { src: string; sizes: string }[];
      };
      return Promise.all(
        icons.map(async ({ src, sizes }) => {
          const image = new Image();
          image.src = src;
          await image.decode();
          return [sizes, `${image.naturalWidth}x${image.naturalHeight}`] as const;
        }),
      );
    });
    for (const [said, real] of sizes) if (said !== 'any') expect(real).toBe(said);
  });

  await test.step('a file that the page is opened with is read', async () => {
    await page.evaluate(() => {
      const file = new File(['06 06 02 AB 10 00 F5 E5\n'.repeat(3000)], 'bus.log');
      (window as unknown as { launch(launched: unknown): void }).launch({ files: [{ getFile: async () => file }] });
    });
    await expect(page.getByRole('button', { name: /^3,000 frames/ })).toBeVisible();
  });

  await test.step('what another program shares goes to the worker, and is read', async () => {
    const box = page.getByRole('textbox', { name: input.label });
    // It opens the page by a form that it sends, as a system's list of programs does.
    await page.goto('about:blank');
    await page.setContent(`
      <form method="post" enctype="multipart/form-data" action="${address}share">
        <textarea name="text">11 03 00 6B 00 03 76 87</textarea>
        <button>Share</button>
      </form>`);
    await page.getByRole('button', { name: 'Share' }).click();
    await expect(box).toHaveValue('11 03 00 6B 00 03 76 87');
    expect(new URL(page.url()).search).toBe('');
    expect(server.sent).toEqual([]);
    await page.goto(`${address}?shared`);
    await expect.poll(() => new URL(page.url()).search).toBe('');
    await expect(box).toHaveValue('');
  });

  await context.setOffline(true);
  await page.goto(`${address}index.html`);
  await page.goto(address);
  for (const [view, use] of Object.entries(everyView)) await test.step(`${view}, offline`, () => use(page));
  await context.setOffline(false);
});

test.describe('of an update', () => {
  test.use({ expected: /^(404|failed|console error: Failed to load resource):? / });

  test('of which a file is missing, cut or changed nothing is installed; a sound one is offered, and comes with what was typed', async ({
    page,
    context,
    address,
    server,
  }) => {
    // The browser keeps what this view needs: that it keeps all is tested above, and takes seconds.
    server.broken.set('offline-worker.js', 'missing');
    const link = `${address}#rtu/request?unitId=33&functionCode=3&startAddress=999&quantity=4`;
    await page.goto(link);
    const field = new FrameForm(page).field('quantity');
    await field.fill('12x');
    await allCame(page);
    server.publish('first', [...server.came]);
    server.broken.clear();
    await page.reload();
    await kept(page);
    server.publish('second');

    for (const how of ['missing', 'cut', 'changed'] satisfies Broken[]) {
      await test.step(`an update of which a file is ${how}`, async () => {
        // The only file of which the browser has no sound copy yet.
        server.broken.set('index.html', how);
        expect(await update(page), how).toBe('redundant');
        await expect(offer(page), how).toHaveCount(0);
      });
    }
    await test.step('the page that is kept goes on', async () => {
      await context.setOffline(true);
      await page.reload();
      await expect(page.getByRole('list', { name: 'The frame' })).toBeVisible();
      await expectVersion(page, 'first');
      await context.setOffline(false);
    });

    await test.step('a sound update is offered', async () => {
      server.broken.clear();
      expect(await update(page)).toBe('installed');
      await offer(page).getByRole('button', { name: words.later }).click();
      await expect(offer(page)).toHaveCount(0);
      await expectVersion(page, 'first');
      await page.reload();
      await expect(offer(page)).toBeVisible();
      await expectVersion(page, 'first');
    });
    await test.step('it comes with what was typed', async () => {
      await field.fill('13x');
      await offer(page).getByRole('button', { name: words.reload }).click();
      await expectVersion(page, 'second');
      await expect(field).toHaveValue('13x');
      await expect(offer(page)).toHaveCount(0);
    });
  });
});
