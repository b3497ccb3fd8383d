import { expect, type Locator, type Page } from '@playwright/test';
import { languages } from '#known';

const words = await languages.en.library();

/** A maker's table: a title, German headers, decimal commas, function codes, a row that is no register. */
export const MAP = `Wärmepumpe WP 12;;;;;
;;;;;
Adresse;Bezeichnung;Funktion;Datentyp;Einheit;Faktor
1100;Vorlauftemperatur;4;int16;°C;0,1
1102;Betriebsart;3;uint16;;
abc;Reserve;3;uint16;;
`;

/** The view of the devices and their register maps as a person meets it. */
export class RegisterMaps {
  readonly page: Page;
  /** What asks about a map that is imported. */
  readonly assistant: Locator;
  /** The list of all devices. */
  readonly library: Locator;
  readonly registers: Locator;

  constructor(page: Page) {
    this.page = page;
    this.assistant = page.getByRole('region', { name: /^Import of / });
    this.library = page.getByRole('region', { name: words.profiles });
    this.registers = page.getByRole('group', { name: 'Registers of this device' });
  }

  async choose(name: string, text: string): Promise<void> {
    await this.page
      .getByLabel(words.chooseFile)
      .setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(text) });
    await expect(this.assistant).toBeVisible();
  }

  async keep(): Promise<void> {
    await this.assistant.getByRole('button', { name: words.keep, exact: true }).click();
    await expect(this.assistant).toHaveCount(0);
  }

  async openDevice(name: RegExp): Promise<void> {
    await this.library.getByRole('button', { name }).click();
  }

  /** The names of the registers, in the order in which they stand. */
  names(): Promise<string[]> {
    return this.registers.locator('tbody th').allTextContents();
  }
}
