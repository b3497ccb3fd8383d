import { encodeFrame, spacedHex, toHex } from '../modbus/index.ts';
import { newStep, type SequenceTexts } from './texts.ts';

const WEG_UNIT = 6;
const SPEED = 681;
const CONTROL = 682;
const REFERENCE = 683;

/** Pairs of digits with blanks between them. */
const write = (address: number, value: number): string =>
  spacedHex(
    toHex(
      encodeFrame({
        transport: 'rtu',
        direction: 'request',
        unitId: WEG_UNIT,
        functionCode: 0x06,
        fields: { address, value },
      }),
    ),
  );

/** The program of the guide: 8192 is 60 Hz, so that 30 Hz is 4096. Its checksums are not those it prints. */
const startMotor: SequenceTexts = {
  name: 'WEG drive: start the motor at 30 Hz',
  about:
    'From “Modbus RTU for PLC Implementation, Complete Guide”: set 30 Hz, wait 10 ms, run, and stop at last. The wait for 29.3 Hz and the ten seconds of running are added. A CFW-11 needs 3 in P0682 to run.',
  transport: 'rtu',
  steps: [
    newStep('send', { bytes: write(REFERENCE, 4096) }),
    newStep('wait', { duration: '10' }),
    newStep('send', { bytes: write(CONTROL, 1) }),
    newStep('until', {
      unit: String(WEG_UNIT),
      address: String(SPEED),
      type: 'i16',
      relation: '≥',
      value: '4000',
      interval: '100',
      timeout: '5000',
    }),
    newStep('wait', { duration: '10000' }),
  ],
  finally: [newStep('send', { bytes: write(CONTROL, 0) })],
};

/** Sequences that come with the page. */
export const builtInSequences: readonly SequenceTexts[] = [startMotor];
