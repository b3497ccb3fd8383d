const COUNT = 1_000_000;
const CONNECTIONS = 20;
const ETHERNET = 14;
const IP = 20;
const TCP = 20;
const MBAP = 7;
const LARGEST = 16 + ETHERNET + IP + TCP + MBAP + 16;

/** A pcap file of a million packets: clients that read five registers of a server again and again, every millisecond. */
export function millionPackets() {
  const bytes = new Uint8Array(24 + COUNT * LARGEST);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, 0xa1b2c3d4, true);
  view.setUint16(4, 2, true);
  view.setUint16(6, 4, true);
  view.setUint32(16, 65_535, true);
  view.setUint32(20, 1, true);
  const sent = [new Uint32Array(CONNECTIONS).fill(1000), new Uint32Array(CONNECTIONS).fill(5000)];
  let at = 24;
  for (let index = 0; index < COUNT; index++) {
    const connection = (index >> 1) % CONNECTIONS;
    const [us, them] = index % 2 === 0 ? [0, 1] : [1, 0];
    const adu = us === 0 ? request(index) : reply(index);
    const length = ETHERNET + IP + TCP + adu.length;
    view.setUint32(at, 1_700_000_000 + Math.floor(index / 2000), true);
    view.setUint32(at + 4, (index % 2000) * 500, true);
    view.setUint32(at + 8, length, true);
    view.setUint32(at + 12, length, true);
    at += 16;
    view.setUint16(at + 12, 0x0800);
    at += ETHERNET;
    const [client, server] = [0xc0000201 + connection, 0xc00002fe];
    bytes[at] = 0x45;
    view.setUint16(at + 2, length - ETHERNET);
    bytes[at + 8] = 64;
    bytes[at + 9] = 6;
    view.setUint32(at + 12, us === 0 ? client : server);
    view.setUint32(at + 16, us === 0 ? server : client);
    at += IP;
    view.setUint16(at, us === 0 ? 49_152 + connection : 502);
    view.setUint16(at + 2, us === 0 ? 502 : 49_152 + connection);
    view.setUint32(at + 4, sent[us][connection]);
    view.setUint32(at + 8, sent[them][connection]);
    bytes[at + 12] = 0x50;
    bytes[at + 13] = 0x18;
    view.setUint16(at + 14, 0x2000);
    at += TCP;
    sent[us][connection] += adu.length;
    bytes.set(adu, at);
    at += adu.length;
  }
  return bytes.subarray(0, at);
}

/** The same packets as pcapng, each in a block of its own. */
export function asPcapng(pcap) {
  const from = new DataView(pcap.buffer, pcap.byteOffset, pcap.byteLength);
  const [section, link, block] = [28, 20, 32];
  const bytes = new Uint8Array(section + link + pcap.length + COUNT * (block + 3));
  const view = new DataView(bytes.buffer);
  const put = (at, values) => {
    for (const [index, value] of values.entries()) view.setUint32(at + 4 * index, value, true);
  };
  put(0, [0x0a0d0d0a, section, 0x1a2b3c4d, 1, 0xffffffff, 0xffffffff, section]);
  put(section, [1, link, 1, 65_535, link]);
  let at = section + link;
  for (let packet = 24; packet < pcap.length; ) {
    const [seconds, fraction, length] = [0, 4, 8].map((field) => from.getUint32(packet + field, true));
    const time = BigInt(seconds) * 1_000_000n + BigInt(fraction);
    const size = block + ((length + 3) & ~3);
    put(at, [6, size, 0, Number(time >> 32n), Number(time & 0xffffffffn), length, length]);
    bytes.set(pcap.subarray(packet + 16, packet + 16 + length), at + 28);
    put(at + size - 4, [size]);
    at += size;
    packet += 16 + length;
  }
  return bytes.subarray(0, at);
}

/** A log of a million lines: the same registers of eight units on a serial line, with the time and the direction before the bytes. */
export function millionLines(crc16) {
  const pairs = (bytes) => Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0').toUpperCase()).join(' ');
  const closed = (bytes) => [...bytes, low(crc16(Uint8Array.from(bytes))), high(crc16(Uint8Array.from(bytes)))];
  const lines = [];
  for (let index = 0; index < COUNT; index++) {
    const unit = 1 + ((index >> 1) % 8);
    const time = new Date(1_700_000_000_000 + 25 * index).toISOString().slice(0, 23).replace('T', ' ');
    const [side, bytes] = index % 2 === 0 ? ['TX', request(index)] : ['RX', reply(index)];
    lines.push(`${time} ${side} ${pairs(closed([unit, ...bytes.slice(7)]))}`);
  }
  return new TextEncoder().encode(`${lines.join('\n')}\n`);
}

const high = (number) => (number >> 8) & 0xff;
const low = (number) => number & 0xff;
const transaction = (index) => [high(index >> 1), low(index >> 1), 0, 0];
const request = (index) => [...transaction(index), 0, 6, 1, 3, high(index % 1000), low(index % 1000), 0, 5];
const reply = (index) => [...transaction(index), 0, 13, 1, 3, 10, 0, 1, 0, 2, 0, 3, 0, 4, high(index), low(index)];
