import { type Datagram, networkLinks, u16 } from './network.ts';

const IN_IP: ReadonlySet<number> = new Set([4, 41]);
const GRE = 47;
const UDP = 17;
const IP_TYPES: ReadonlySet<number> = new Set([0x0800, 0x86dd]);
const BRIDGED = 0x6558;
/** Flags of GRE that each add four bytes to its header: checksum, key, sequence (RFC 2784, RFC 2890); and its version. */
const GRE_FIELDS = [0x8000, 0x2000, 0x1000] as const;
const GRE_VERSION = 0x0007;
const GRE_HEADER = 4;
const VXLAN_PORT = 4789;
const VXLAN = { from: 8, header: 8 } as const;

const ethernet = (bytes: Uint8Array, at: number, end: number): number => networkLinks.get(1)?.(bytes, at, end) ?? -1;

/** Where the IP packet begins that a datagram carries: IP in IP (RFC 2003), GRE, or VXLAN (RFC 7348); −1 if it carries none. */
export function tunnelled({ protocol, bytes, from, to }: Datagram): number {
  if (IN_IP.has(protocol)) return from;
  if (protocol === GRE && from + GRE_HEADER < to) {
    const flags = u16(bytes, from);
    const type = u16(bytes, from + 2);
    const at = from + GRE_HEADER + 4 * GRE_FIELDS.filter((field) => (flags & field) !== 0).length;
    if ((flags & GRE_VERSION) !== 0) return -1;
    return IP_TYPES.has(type) ? at : type === BRIDGED ? ethernet(bytes, at, to) : -1;
  }
  if (protocol !== UDP || from + VXLAN.from + VXLAN.header >= to || u16(bytes, from + 2) !== VXLAN_PORT) return -1;
  return ethernet(bytes, from + VXLAN.from + VXLAN.header, to);
}
