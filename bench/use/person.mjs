// A person with a mouse, keys and a clipboard, who counts what they do.

/** What somebody did to reach something. */
export class Person {
  clicks = 0;
  fields = 0;
  scrolls = 0;
  pastes = 0;

  /** @param {import('@playwright/test').Page} page */
  constructor(page) {
    this.page = page;
  }

  /** Whether a thing lies wholly in the window, and nothing covers its middle. */
  async sees(locator) {
    await locator.waitFor();
    return locator.evaluate((element) => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      if (top < 0 || left < 0 || bottom > innerHeight + 1 || right > innerWidth + 1) return false;
      const over = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      return over !== null && (element.contains(over) || over.contains(element));
    });
  }

  /** Brings a thing into sight with the wheel, a scroll for each turn of at most a window's height. */
  async reach(locator) {
    await locator.waitFor();
    for (let turns = 0; turns < 10; turns++) {
      if (await this.sees(locator)) return;
      const { x, away } = await locator.evaluate((element) => {
        const { left, right, top, bottom } = element.getBoundingClientRect();
        return { x: (left + right) / 2, away: (top + bottom) / 2 - innerHeight / 2 };
      });
      const { width, height } = this.page.viewportSize();
      // Above what the thing stands in, which may scroll by itself.
      await this.page.mouse.move(Math.max(10, Math.min(width - 10, x)), away > 0 ? height - 40 : height / 2);
      await this.page.mouse.wheel(0, Math.max(-height, Math.min(height, away)));
      await this.page.waitForTimeout(120);
      this.scrolls += 1;
    }
  }

  async click(locator) {
    await this.reach(locator);
    await locator.click();
    this.clicks += 1;
  }

  /** Opens a list and chooses in it: two clicks. */
  async choose(locator, option) {
    await this.reach(locator);
    await locator.selectOption(option);
    this.clicks += 2;
  }

  /** Types a text over what a field holds. Going there by a click counts as a part of it. */
  async type(locator, text) {
    await this.reach(locator);
    await locator.click();
    await this.page.keyboard.press('ControlOrMeta+A');
    await this.page.keyboard.type(text);
    this.fields += 1;
  }

  /** Pastes a text where the focus is. */
  async paste(text) {
    await this.page.evaluate((content) => navigator.clipboard.writeText(content), text);
    await this.page.keyboard.press('ControlOrMeta+V');
    this.pastes += 1;
  }

  async press(key) {
    await this.page.keyboard.press(key);
  }

  /** What an act puts into the clipboard. */
  async copied(act) {
    const read = () => this.page.evaluate(() => navigator.clipboard.readText());
    await this.page.evaluate(() => navigator.clipboard.writeText(''));
    await act();
    for (let tries = 0; tries < 40; tries++) {
      const text = await read();
      if (text !== '') return text;
      await this.page.waitForTimeout(50);
    }
    throw new Error('Nothing was copied.');
  }
}
