import { describe, expect, it } from 'vitest';
import { fromHex, toHex } from '../../../../src/modbus/index.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import { otherFrame } from '../../../../src/workbench/frame/other-frame.ts';
import { replyTo } from '../../../../src/workbench/frame/pair.ts';

const drafted = (link: string) => {
  const { draft } = readLink(link)!;
  return { draft, ...evaluate(draft).frame! };
};
const of = (link: string) => {
  const { draft, ...frame } = drafted(link);
  return otherFrame(draft, frame);
};
/** The frame that a draft comes to. */
const hexOf = (draft: Parameters<typeof evaluate>[0]) => toHex(evaluate(draft).frame!.bytes);

const READ = '#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3';

describe('the other frame of an exchange', () => {
  it('is what a request should get, with the bytes that only the device knows', () => {
    const read = of(READ);
    // 11 03 06, six bytes of 0, and the exception 11 83 02: the CRC of the latter is 0x34C1.
    expect(read).toMatchObject({ kind: 'expected', how: 'layout', values: 6 });
    expect(read.kind === 'expected' && toHex(read.reply!.bytes.subarray(0, 9))).toBe('110306000000000000');
    expect(read.kind === 'expected' && toHex(read.exception!.bytes)).toBe('118302C134');
    const write = of('#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096');
    expect(write).toMatchObject({ kind: 'expected', how: 'exact', values: 0 });
    expect(write.kind === 'expected' && toHex(write.reply!.bytes)).toBe('060602AB1000F5E5');
    expect(of('#rtu/request?unitId=1&functionCode=17')).toMatchObject({ kind: 'expected', how: 'open' });
  });

  it('is silence where nothing answers', () => {
    expect(of('#rtu/request?unitId=0&functionCode=6&address=1&value=3')).toEqual({ kind: 'silence', why: 'broadcast' });
    expect(of('#rtu/request?unitId=1&functionCode=8&subFunction=4&data=00 00')).toEqual({
      kind: 'silence',
      why: 'silent',
    });
  });

  it('is the request that a reply answers, if it is known', () => {
    const reply = '#rtu/reply?unitId=17&functionCode=3&registers=555+0+100';
    expect(of(reply)).toEqual({ kind: 'no-request' });
    const answering = of(`${reply}&answering=1103006B00037687`);
    expect(answering).toMatchObject({ kind: 'request', why: 'unit-function-length' });
    expect(answering.kind === 'request' && toHex(answering.frame.bytes)).toBe('1103006B00037687');
    expect(of(`${reply}&answering=1103006B00013746`)).toMatchObject({ kind: 'request', why: 'differs' });
  });

  it('is the reply that came to a request, and leads back to it', () => {
    const request = drafted(READ);
    // 555, 0 and 100 in registers 107 to 109: the example of AP 6.3.
    const draft = replyTo(request, fromHex('110306022B00000064C8BA')!)!;
    const asked = otherFrame(draft, evaluate(draft).frame!);
    expect(asked).toMatchObject({ kind: 'request', why: 'unit-function-length' });
    if (asked.kind !== 'request') return;
    expect(hexOf(asked.frame.draft)).toBe('1103006B00037687');
    const came = otherFrame(asked.frame.draft, evaluate(asked.frame.draft).frame!);
    expect(came).toMatchObject({ kind: 'reply', why: 'unit-function-length' });
    expect(came.kind === 'reply' && hexOf(came.frame.draft)).toBe('110306022B00000064C8BA');
  });
});
