import { describe, expect, it } from 'vitest';
import { diagnose, identify } from '../../../../src/diagnosis/index.ts';
import { fromHex } from '../../../../src/modbus/index.ts';
import { primaryRepair } from '../../../../src/workbench/frame/primary-repair.ts';
import { readText } from '../../../../src/workbench/reading/read-text.ts';

const hex = (text: string) => fromHex(text.replaceAll(' ', ''))!;

function repairOf(text: string) {
  const bytes = hex(text);
  const { reading } = identify(bytes)[0]!;
  return primaryRepair({ bytes, reading }, diagnose(bytes, { transport: reading.transport }));
}

describe('the repair that is offered first', () => {
  it('is the checksum alone where nothing else is wrong, also of a frame that a manual misprints', () => {
    const repaired = { bytes: hex('06 06 02 AB 10 00 F5 E5'), changes: 'checksum', part: hex('F5 E5') };
    expect(repairOf('06 06 02 AB 10 00 E6 A1')).toEqual({ ...repaired, finding: 'known-misprint' });
    expect(repairOf('06 06 02 AB 10 00 E5 F5')).toEqual({ ...repaired, finding: 'crc-byte-order' });
  });

  it('adds the checksum that is missing', () => {
    expect(repairOf('06 06 02 AB 10 00')).toEqual({
      finding: 'crc-missing',
      bytes: hex('06 06 02 AB 10 00 F5 E5'),
      changes: 'checksum',
      part: hex('F5 E5'),
    });
  });

  it('is the whole frame where more changes', () => {
    // The request of AP 6.3 with one bit of its quantity turned.
    expect(repairOf('11 03 00 6B 00 07 76 87')).toMatchObject({
      changes: 'frame',
      part: hex('11 03 00 6B 00 03 76 87'),
    });
  });

  it('is none of a frame with nothing wrong', () => {
    expect(repairOf('11 03 00 6B 00 03 76 87')).toBeUndefined();
  });
});

describe('code of a frame without its checksum, and the one that a comment says', () => {
  it('is repaired by adding the checksum, and the comment is compared', () => {
    const code = 'uint8_t message[6] = {0x06, 0x06, 0x02, 0xAB, 0x10, 0x00};\n// Should be: 0xA1E6';
    const { bytes, problems } = readText(code, undefined);
    expect(bytes).toEqual(hex('06 06 02 AB 10 00'));
    expect(problems).toMatchObject([{ code: 'checksum-said', got: 0xa1e6, expected: 0xe5f5 }]);
    expect(repairOf('06 06 02 AB 10 00')).toMatchObject({ finding: 'crc-missing', part: hex('F5 E5') });
  });
});
