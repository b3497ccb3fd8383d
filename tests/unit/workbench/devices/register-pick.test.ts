import { describe, expect, it } from 'vitest';
import { builtInProfiles, readRequest } from '../../../../src/devices/index.ts';
import { deviceRequest, functionFor, picked, withByteCount } from '../../../../src/workbench/devices/register-pick.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';

/** The bytes that picking a register puts into a frame, and the function it is offered with. */
function pick(hash: string, device: string, name: string, path = 'startAddress') {
  const { draft } = readLink(hash)!;
  const field = { draft, evaluation: evaluate(draft), path };
  const profile = builtInProfiles.find(({ id }) => id === device)!;
  const register = profile.registers.find((each) => each.name === name)!;
  const { frame } = evaluate(picked(field, profile, register));
  return { offered: functionFor(field, profile, register), hex: Buffer.from(frame!.bytes).toString('hex') };
}

const SPEED = 'P0683 speed reference';

describe('a request to a device', () => {
  const weg = builtInProfiles.find(({ id }) => id === 'weg-drive')!;
  const speed = weg.registers.find(({ name }) => name === SPEED)!;
  const requested = (hash: string) => evaluate(deviceRequest(readLink(hash)!.draft, readRequest(weg, speed), 6)).frame!;

  it('is for the unit of the device on a serial line, and leaves the unit elsewhere', () => {
    // AP 6.3: one register from 683 (0x02AB) on, for unit 6.
    expect(Buffer.from(requested('#rtu/request?unitId=1').bytes).toString('hex', 0, 6)).toBe('060302ab0001');
    expect(String.fromCharCode(...requested('#ascii/request?unitId=1').bytes)).toMatch(/^:060302AB0001/);
    expect(Buffer.from(requested('#tcp/request?unitId=1').bytes).toString('hex', 6)).toBe('010302ab0001');
    expect(Buffer.from(requested('#pdu/request?').bytes).toString('hex')).toBe('0302ab0001');
  });

  it('keeps the unit if the device has none', () => {
    const { draft } = readLink('#rtu/request?unitId=1')!;
    expect(evaluate(deviceRequest(draft, readRequest(weg, speed), undefined)).frame!.bytes[0]).toBe(1);
  });

  it('can have a byte of bits more than the specification counts', () => {
    const { draft } = readLink('#pdu/request?functionCode=15&startAddress=0&bits=11111111')!;
    expect(Buffer.from(evaluate(withByteCount(draft, 2)).frame!.bytes).toString('hex')).toBe('0f0000000802ff00');
  });
});

describe('a register that is picked', () => {
  it('sets address and quantity of a read', () => {
    expect(pick('#pdu/request?functionCode=3&startAddress=0&quantity=9', 'weg-drive', SPEED)).toEqual({
      offered: 0x03,
      hex: '0302ab0001',
    });
    // 125 registers are the most of one request (AP 6.3).
    expect(pick('#pdu/request?functionCode=3&startAddress=0&quantity=9', 's7-200', 'VW{800+2n}').hex).toBe(
      '030000007d',
    );
  });

  it('keeps the value of a write', () => {
    expect(pick('#pdu/request?functionCode=6&address=0&value=4096', 'weg-drive', SPEED, 'address')).toEqual({
      offered: 0x06,
      hex: '0602ab1000',
    });
    expect(pick('#pdu/request?functionCode=16&startAddress=0&registers=7', 's7-200', 'VW{800+2n}')).toEqual({
      offered: 0x10,
      hex: '10000000010200' + '07',
    });
    expect(
      pick(
        '#pdu/request?functionCode=22&referenceAddress=0&andMask=0xF2&orMask=0x25',
        'weg-drive',
        SPEED,
        'referenceAddress',
      ),
    ).toEqual({ offered: 0x16, hex: '1602ab00f20025' });
  });

  it('takes the function of its table', () => {
    const integers = 'Integer {0000h+1n} by 04';
    expect(pick('#pdu/request?functionCode=3&startAddress=5&quantity=1', 'i-8xx7', integers)).toEqual({
      offered: 0x04,
      hex: '040000007d',
    });
    expect(pick('#pdu/request?functionCode=6&address=5&value=1', 'i-8xx7', integers, 'address')).toEqual({
      offered: 0x04,
      hex: '040000007d',
    });
    expect(
      pick('#pdu/request?functionCode=6&address=5&value=1', 'weg-drive', 'P0681 actual speed', 'address').hex,
    ).toBe('0302a90001');
  });

  it('of 32 bits is written by 10, by Enron’s count with quantity 1 and byte count 4', () => {
    expect(pick('#pdu/request?functionCode=6&address=5&value=1', 'enron-daniel', 'Float {7001+1n}', 'address')).toEqual(
      {
        offered: 0x10,
        hex: '101b5900010400000000',
      },
    );
  });

  it('has only an address in a reply, and another table has none there', () => {
    const reply = '#pdu/reply?functionCode=6&address=0&value=4096';
    expect(pick(reply, 'weg-drive', SPEED, 'address')).toEqual({ offered: 0x06, hex: '0602ab1000' });
    expect(pick(reply, 'i-8xx7', 'Boolean {0000h+1n}', 'address').offered).toBeUndefined();
  });

  it('of function 17 goes to the address it is picked for', () => {
    const both =
      '#pdu/request?functionCode=23&readStartAddress=3&readQuantity=6&writeStartAddress=14&writeRegisters=255 255 255';
    expect(pick(both, 'weg-drive', 'P0681 actual speed', 'readStartAddress').hex).toBe(
      '1702a90001000e00030600ff00ff00ff',
    );
    expect(pick(both, 'weg-drive', SPEED, 'writeStartAddress').hex).toBe('170003000602ab0001020000');
  });
});
