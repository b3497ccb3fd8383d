import { Bus } from './harness/bus.ts';
import { expect, test } from './harness/fixtures.ts';

test('libmodbus answers every function it knows, an exception, and where it is not the unit, nothing', async ({
  page,
  plugAdapter,
}) => {
  const bus = new Bus(page);
  await plugAdapter();
  await bus.hold('01 01 00 00 00 0A BC 0D');
  await bus.choose();
  await bus.readOnly.uncheck();

  // 01: every third coil from 0 is on.
  await bus.ask('01 01 00 00 00 0A BC 0D', '01 01 02 49 02 0F AD');
  // 02: every second input from 0 is on.
  await bus.ask('01 02 00 00 00 08 79 CC', '01 02 01 55 61 B7');
  // 03: registers 10 and 11 are 1010 and 1011.
  await bus.ask('01 03 00 0A 00 02 E4 09', '01 03 04 03 F2 03 F3 1B 31');
  // 04: input register 5 is 2005.
  await bus.ask('01 04 00 05 00 01 21 CB', '01 04 02 07 D5 7A 9F');

  // 05: coil 1 on, asked for once.
  await bus.hold('01 05 00 01 FF 00 DD FA');
  await bus.button('Send').click();
  await expect(bus.question).toContainText('This may change something in device 1. You will be asked once per device.');
  await bus.question.getByRole('button', { name: 'Send', exact: true }).click();
  await expect(bus.reply.locator('.bytes-line')).toHaveText('01 05 00 01 FF 00 DD FA');
  await bus.ask('01 01 00 00 00 0A BC 0D', '01 01 02 4B 02 0E CD');
  // 06: register 20 becomes 1234.
  await bus.ask('01 06 00 14 12 34 C4 B9', '01 06 00 14 12 34 C4 B9');
  await bus.ask('01 03 00 14 00 01 C4 0E', '01 03 02 12 34 B5 33');
  // 0F: coils 10 to 13 become on, on, off, on.
  await bus.ask('01 0F 00 0A 00 04 01 0B E7 50', '01 0F 00 0A 00 04 74 0A');
  await bus.ask('01 01 00 0A 00 04 1D CB', '01 01 01 0B 10 4F');
  // 10: registers 30 and 31 become 000A and 0102.
  await bus.ask('01 10 00 1E 00 02 04 00 0A 01 02 D3 7C', '01 10 00 1E 00 02 21 CE');
  // 16: register 4, which is 03EC, becomes (03EC and 00F2) or (0025 and not 00F2).
  await bus.ask('01 16 00 04 00 F2 00 25 67 EE', '01 16 00 04 00 F2 00 25 67 EE');
  await bus.ask('01 03 00 04 00 01 C5 CB', '01 03 02 00 E5 79 CF');
  // 17: register 40 becomes BEEF, registers 30 and 31 are read.
  await bus.ask('01 17 00 1E 00 02 00 28 00 01 02 BE EF 42 DF', '01 17 04 00 0A 01 02 59 74');
  await bus.ask('01 03 00 28 00 01 04 02', '01 03 02 BE EF 88 68');

  // There is no register 250.
  await bus.ask('01 03 00 FA 00 01 A4 3B', '01 83 02 C0 F1', 'The device refused the request: exception 02');

  // Unit 9 is not there.
  await bus.unfold();
  await bus.setting('Time-out (ms)').fill('0xC8');
  await bus.hold('09 03 00 00 00 01 85 42');
  await bus.button('Send').click();
  await expect(bus.result).toContainText('No device answered: unit ');
  await expect(bus.lines.last()).toContainText('no reply');
});

test('the guard: nothing is written while read only, and what is asked is asked as often as it says', async ({
  page,
  plugAdapter,
}) => {
  const bus = new Bus(page);
  const answer = (name: string) => bus.question.getByRole('button', { name, exact: true }).click();
  await plugAdapter();
  await bus.hold('01 06 00 14 12 34 C4 B9');
  await bus.choose();

  await bus.button('Send').click();
  await expect(bus.result).toContainText('Not sent: it may change something in a device, and “Read only” is on.');
  await bus.readOnly.uncheck();
  await bus.button('Send').click();
  await answer('Do not send');
  await expect(bus.question).toBeHidden();
  await bus.button('Send').click();
  await expect(bus.question).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(bus.question).toBeHidden();
  // Register 20 is what it was.
  await bus.ask('01 03 00 14 00 01 C4 0E', '01 03 02 03 FC B8 F5');
  await expect(bus.lines).toHaveCount(2);

  await bus.hold('01 06 00 14 12 34 C4 B9');
  await bus.button('Send').click();
  await answer('Send');
  await expect(bus.lines).toHaveCount(4);
  await bus.button('Send').click();
  await expect(bus.lines).toHaveCount(6);
  await expect(bus.question).toBeHidden();

  // Register 20 of all devices becomes 7; nobody answers.
  await bus.hold('00 06 00 14 00 07 89 DD');
  for (const lines of [7, 8]) {
    await bus.button('Send').click();
    await expect(bus.question).toContainText(
      'This is a broadcast: every device on the line obeys it, and no device answers.',
    );
    await answer('Send');
    await expect(bus.lines).toHaveCount(lines);
  }
  await expect(bus.result).toContainText('Sent. No device answers this request.');
  await bus.ask('01 03 00 14 00 01 C4 0E', '01 03 02 00 07 F9 86');

  // 126 registers at once are one too many.
  await bus.hold('01 03 00 00 00 7E C5 EA');
  await bus.button('Send').click();
  await expect(bus.question).toContainText('This frame breaks a rule of the specification');
  await answer('Send');
  await expect(bus.reply).toContainText('01 83 03 01 31');

  await bus.readOnly.check();
  await bus.hold('01 06 00 14 12 34 C4 B9');
  await bus.button('Send').click();
  await expect(bus.result).toContainText('Not sent: it may change something in a device');
});
