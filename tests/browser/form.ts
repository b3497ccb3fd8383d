import { expect, type Locator, type Page } from '@playwright/test';
import { languages } from '#known';

const en = await languages.en.page();
const more = await languages.en.stripMore();

/** A frame of tests/vectors/frames.json. */
export interface VectorFrame {
  readonly id: string;
  readonly transport: 'rtu' | 'ascii' | 'tcp' | 'pdu';
  readonly direction: 'request' | 'response';
  readonly hex: string;
  readonly unitId?: number;
  readonly transactionId?: number;
  readonly functionCode: number;
  readonly request?: string;
  readonly fields: Readonly<Record<string, unknown>>;
}

/** The form as a person meets it: by the labels of its fields. */
export class FrameForm {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  field(name: string, scope: Page | Locator = this.page): Locator {
    const label = en.labels[name] ?? name;
    return scope.getByLabel(label, { exact: true });
  }

  async choose(legend: string, option: string): Promise<void> {
    await this.page.getByRole('group', { name: legend }).getByRole('radio', { name: option, exact: true }).check();
  }

  async chooseFunction(code: number, kind: 'Request' | 'Reply' | 'Exception' = 'Request'): Promise<void> {
    const label = kind === 'Exception' ? en.page.exceptionTo : en.page.functionLabel;
    const field = this.page.getByLabel(label, { exact: true });
    await field.fill(hexOf(code));
    await field.press('Enter');
  }

  /** Opens a frame by its link, without loading the page again. */
  async open(frame: VectorFrame): Promise<void> {
    await this.page.evaluate((hash) => {
      location.hash = hash;
    }, linkOf(frame));
  }

  /** Types a whole frame into the form. */
  async fill(frame: VectorFrame): Promise<void> {
    const isException = frame.functionCode > 0x7f;
    const kind = isException ? 'Exception' : frame.direction === 'request' ? 'Request' : 'Reply';
    await this.choose(en.page.transport, en.page.transports[frame.transport]);
    await this.choose(en.page.kind, kind);
    await this.chooseFunction(frame.functionCode & 0x7f, kind);
    if (frame.unitId !== undefined) await this.field('unitId').fill(String(frame.unitId));
    if (frame.transactionId !== undefined) await this.field('transactionId').fill(hexOf(frame.transactionId));
    if (kind !== 'Request') await this.answer(frame.request ?? '');
    await this.fillFields(frame.fields, this.page);
  }

  /** Chooses a device in the first line of the form. */
  async chooseDevice(name: string): Promise<void> {
    const form = this.page.getByRole('form', { name: en.page.build });
    await form.getByRole('button', { name: /^Device: / }).click();
    await form.getByRole('button', { name: new RegExp(`^${name.replace(/[()]/g, '\\$&')}`) }).click();
  }

  /** Types the request that a reply answers. */
  async answer(request: string): Promise<void> {
    await this.page.getByRole('button', { name: more.editAnswering('') }).click();
    const field = this.page.getByLabel(more.answering, { exact: true });
    await field.fill(request);
    await field.press('Enter');
  }

  private async fillFields(fields: Readonly<Record<string, unknown>>, scope: Page | Locator): Promise<void> {
    // Text of an object is typed as its value, so that its pairs need no second field.
    const { value, ...others } = 'valueHex' in fields ? fields : { ...fields, value: undefined };
    const all = 'valueHex' in fields ? others : fields;
    for (const [name, given] of Object.entries(all)) {
      if (Array.isArray(given) && typeof given[0] === 'object') await this.fillGroups(name, given);
      else if (Array.isArray(given)) await this.field(name, scope).fill(given.join(' '));
      else if (typeof given === 'boolean') await this.field(name, scope).selectOption(given ? '1' : '0');
      else await this.fillOne(name, given as number | string, scope);
    }
  }

  private async fillOne(name: string, value: number | string, scope: Page | Locator): Promise<void> {
    const field = this.field(name, scope);
    if ((await field.evaluate((element) => element.tagName)) !== 'SELECT') {
      await field.fill(typeof value === 'number' && value > 9 ? hexOf(value) : String(value));
      return;
    }
    const listed = await field.locator(`option[value="${value}"]`).count();
    await field.selectOption(listed > 0 ? String(value) : { label: en.page.other });
    if (listed === 0) await this.field(name, scope).fill(String(value));
  }

  private async fillGroups(name: string, groups: readonly Readonly<Record<string, unknown>>[]): Promise<void> {
    const list = this.page.getByRole('group', { name: en.labels[name]!, exact: true });
    // Its groups are numbered; a list inside one has groups of its own.
    const there = list.getByRole('group', { name: /^\d+$/ });
    await expect(list).toBeVisible();
    for (let n = await there.count(); n > groups.length; n--) {
      await list.getByRole('button', { name: `${en.page.remove} ${n}`, exact: true }).click();
    }
    for (let n = await there.count(); n < groups.length; n++) {
      await list.getByRole('button', { name: en.page.add, exact: true }).click();
    }
    for (const [index, group] of groups.entries()) {
      await this.fillFields(group, list.getByRole('group', { name: String(index + 1), exact: true }));
    }
  }

  /** Waits until the page copies this frame, written without blanks. */
  async expectCopied(frame: string | RegExp, what?: string): Promise<void> {
    const pattern = typeof frame === 'string' ? new RegExp(`^${frame}$`) : frame;
    await expect.poll(() => this.#copied(), what).toMatch(pattern);
  }

  async #copied(): Promise<string> {
    await this.page.evaluate(() => navigator.clipboard.writeText(''));
    const frame = this.page.getByRole('region', { name: en.page.bytes });
    await frame.getByRole('button', { name: /^Copy / }).click();
    const text = await this.page.evaluate(async () => {
      let copied = '';
      for (let left = 1000; copied === '' && left > 0; left--) {
        copied = await navigator.clipboard.readText();
        if (copied === '') await new Promise((done) => setTimeout(done, 5));
      }
      return copied;
    });
    return text.replaceAll(' ', '');
  }

  /** Waits until the strip has these bytes, written as pairs. */
  async expectBytes(pairs: string, what?: string): Promise<void> {
    await expect(this.strip.locator('.byte'), what).toHaveText(pairs.split(' ').map((pair) => new RegExp(`^${pair}`)));
  }

  get strip(): Locator {
    return this.page.getByRole('list', { name: en.page.bytes });
  }

  get explanation(): Locator {
    return this.page.getByRole('table', { name: en.page.everyByte });
  }
}

const hexOf = (value: number) => `0x${value.toString(16).toUpperCase()}`;

/** The link to a frame, its fields as a person might have typed them. */
function linkOf({ transport, direction, functionCode, unitId, transactionId, fields, request }: VectorFrame): string {
  const kind = functionCode > 0x7f ? 'exception' : direction === 'request' ? 'request' : 'reply';
  const query = new URLSearchParams({ functionCode: String(functionCode & 0x7f) });
  if (unitId !== undefined) query.set('unitId', String(unitId));
  if (transactionId !== undefined) query.set('transactionId', hexOf(transactionId));
  if (request !== undefined) query.set('answering', request);
  const put = (path: string, value: unknown): void => {
    if (Array.isArray(value) && typeof value[0] === 'object') {
      query.set(path, String(value.length));
      for (const [index, group] of value.entries()) {
        for (const [name, inner] of Object.entries(group)) put(`${path}[${index}].${name}`, inner);
      }
    } else if (typeof value === 'boolean') query.set(path, value ? '1' : '0');
    else query.set(path, Array.isArray(value) ? value.join(' ') : String(value));
  };
  for (const [name, value] of Object.entries(fields)) put(name, value);
  return `#${transport}/${kind}?${query}`;
}
