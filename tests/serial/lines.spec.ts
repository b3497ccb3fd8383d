import { Bus } from './harness/bus.ts';
import { expect, test } from './harness/fixtures.ts';

const REMOVED = 'The adapter returned the request; this echo was removed.';

test('an adapter that echoes is found out, and its echo is told from replies that are the same', async ({
  page,
  plugAdapter,
}) => {
  const bus = new Bus(page);
  await plugAdapter({ echo: true });
  // Register 20 becomes 1234; the reply is the same as the request, and so is the echo.
  await bus.hold('01 06 00 14 12 34 C4 B9');
  await bus.choose();
  await bus.readOnly.uncheck();
  await bus.button('Send').click();
  await bus.question.getByRole('button', { name: 'Send', exact: true }).click();
  await expect(bus.lines).toHaveCount(3);
  await expect(bus.reply).toContainText(REMOVED);
  await expect(bus.lines).toContainText(['request', 'echo of the request', 'reply']);
  await bus.ask('01 03 00 14 00 01 C4 0E', '01 03 02 12 34 B5 33', REMOVED);

  // Unit 9 is not there: only the echo comes, and it is not taken for a reply.
  await bus.unfold();
  await bus.setting('Time-out (ms)').fill('200');
  await bus.hold('09 06 00 14 12 34 C5 F1');
  await bus.button('Send').click();
  await bus.question.getByRole('button', { name: 'Send', exact: true }).click();
  await expect(bus.result).toContainText('No device answered: unit ');
});

test('a line at 9600 baud takes its time, and an adapter that hands over lumps of 16 ms cuts no reply', async ({
  page,
  plugAdapter,
}) => {
  const bus = new Bus(page);
  await plugAdapter({ pace: true, lump: 16 });
  await bus.hold('01 03 00 0A 00 02 E4 09');
  await bus.setting('Speed (baud)').fill('9600');
  await bus.choose();
  await bus.ask('01 03 00 0A 00 02 E4 09', '01 03 04 03 F2 03 F3 1B 31');

  // 125 registers take a third of a second, in some twenty lumps.
  await bus.hold('01 03 00 00 00 7D 85 EB');
  await bus.button('Send').click();
  const reply = bus.reply.locator('.bytes-line');
  // From register 0, which is 1000, to register 124, which is 1124.
  await expect(reply).toHaveText(/^01 03 FA 03 E8 03 E9 03 EA .* 04 63 04 64 .. ..$/);
  await expect(bus.result).toContainText('Answered.');
  await expect(bus.lines).toContainText(['request', 'reply', 'request', 'reply']);
});
