import { describe, expect, it } from 'vitest';
import { formatBytes, readBytes } from '../../../src/notation/index.ts';

const read = (text: string) => {
  const { bytes, chunks, problems } = readBytes(text);
  const told = chunks.map(({ from, to, direction = '-' }) => `${direction}: ${formatBytes(bytes.subarray(from, to))}`);
  const headers = problems.flatMap((problem) =>
    problem.code === 'set-aside' && problem.why === 'headers' ? [text.slice(problem.start, problem.end)] : [],
  );
  return { told, headers };
};

const REQUEST = 'request: 00 01 00 00 00 06 01 03 00 00 00 01';
const REPLY = 'response: 00 01 00 00 00 05 01 03 02 00 2A';

describe('packets of a network', () => {
  it('of tcpdump -X: the headers of IP and TCP are said, and what they carry is read', () => {
    const { told, headers } =
      read(`10:11:12.000123 IP 10.0.0.1.51234 > 10.0.0.2.502: Flags [P.], seq 1:13, ack 1, win 502, length 12
	0x0000:  4500 0034 1234 4000 4006 1485 0a00 0001  E..4.4@.@.......
	0x0010:  0a00 0002 c822 01f6 0000 0001 0000 0001  .....".........
	0x0020:  5018 01f6 0000 0000 0001 0000 0006 0103  P...............
	0x0030:  0000 0001                                ....
10:11:12.004456 IP 10.0.0.2.502 > 10.0.0.1.51234: Flags [P.], seq 1:12, ack 13, win 227, length 11
	0x0000:  4500 0033 1235 4000 4006 1485 0a00 0002  E..3.5@.@.......
	0x0010:  0a00 0001 01f6 c822 0000 0001 0000 000d  ......."........
	0x0020:  5018 00e3 0000 0000 0001 0000 0005 0103  P...............
	0x0030:  0200 2a                                  ..*
10:11:12.004500 IP 10.0.0.1.51234 > 10.0.0.2.502: Flags [.], ack 12, win 502, length 0
	0x0000:  4500 0028 1236 4000 4006 1485 0a00 0001  E..(.6@.@.......
	0x0010:  0a00 0002 c822 01f6 0000 000d 0000 000c  ....."..........
	0x0020:  5010 01f6 0000 0000                      P.......
`);
    expect(told).toEqual([REQUEST, REPLY]);
    expect(headers).toHaveLength(3);
    expect(headers[0]).toMatch(/^45[\s\S]*0000$/);
  });

  it('of Wireshark: Ethernet before, and a time stamp among the options of TCP', () => {
    const { told } = read(`0000   00 80 f4 09 51 3b 00 1b 21 3c 9d f8 08 00 45 00
0010   00 40 12 34 40 00 40 06 14 79 0a 00 00 01 0a 00
0020   00 02 c8 22 01 f6 00 00 00 01 00 00 00 01 80 18
0030   01 f6 00 00 00 00 01 01 08 0a 00 00 00 01 00 00
0040   00 02 00 01 00 00 00 06 01 03 00 00 00 01`);
    expect(told).toEqual([REQUEST]);
  });

  it('with the zeros that pad a short packet, with a VLAN, and over IPv6', () => {
    const padded =
      '00 80 f4 09 51 3b 00 1b 21 3c 9d f8 08 00 45 00 00 2d 12 34 40 00 40 06 14 8c 0a 00 00 01 0a 00 00 02 c8 22 01 f6 00 00 00 01 00 00 00 01 50 18 01 f6 00 00 00 00 01 83 02 c0 f1 00';
    expect(read(padded).told).toEqual(['request: 01 83 02 C0 F1']);
    expect(read(padded).headers.at(-1)).toBe('00');
    const vlan =
      '00 80 f4 09 51 3b 00 1b 21 3c 9d f8 81 00 00 05 08 00 45 00 00 2d 12 34 40 00 40 06 14 8c 0a 00 00 01 0a 00 00 02 01 f6 c8 22 00 00 00 01 00 00 00 01 50 18 01 f6 00 00 00 00 01 83 02 c0 f1';
    expect(read(vlan).told).toEqual(['response: 01 83 02 C0 F1']);
    const six =
      '60 00 00 00 00 20 06 40 fe 80 00 00 00 00 00 00 00 00 00 00 00 00 00 01 fe 80 00 00 00 00 00 00 00 00 00 00 00 00 00 02 c8 22 01 f6 00 00 00 01 00 00 00 01 50 18 01 f6 00 00 00 00 00 01 00 00 00 06 01 03 00 00 00 01';
    expect(read(six).told).toEqual([REQUEST]);
  });

  it('are off before it is judged in which order the bytes of words stand', () => {
    const packet = (port: string, payload: string) => `	0x0000:  4500 0030 1234 4000 4006 0000 0a00 0001
	0x0010:  0a00 0002 ${port} 0000 0001 0000 0001
	0x0020:  5018 01f6 0000 0000 ${payload}
`;
    const { told } = read(packet('c822 01f6', '4605 040d 0000 524e') + packet('01f6 c822', '4605 040d 0001 938e'));
    expect(told).toEqual(['request: 46 05 04 0D 00 00 52 4E', 'response: 46 05 04 0D 00 01 93 8E']);
  });

  it('over UDP, and what the text says of the direction before the ports', () => {
    const udp =
      '45 00 00 28 12 34 40 00 40 11 14 86 0a 00 00 01 0a 00 00 02 c8 22 01 f6 00 14 00 00 00 01 00 00 00 06 01 03 00 00 00 01';
    expect(read(udp).told).toEqual([REQUEST]);
    expect(read(`rx: ${udp}`).told).toEqual([REQUEST.replace('request', 'rx')]);
  });

  it('are not seen in bytes whose lengths say otherwise', () => {
    const cut =
      '45 00 00 34 12 34 40 00 40 06 14 85 0a 00 00 01 0a 00 00 02 c8 22 01 f6 00 00 00 01 00 00 00 01 50 18 01 f6 00 00 00 00 00 01';
    expect(read(cut).told).toEqual([`-: ${cut.toUpperCase()}`]);
    expect(read('45 03 00 00 00 0A C8 89').headers).toEqual([]);
  });
});
