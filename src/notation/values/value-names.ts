import type { Order, Padding, ValueType } from '../../modbus/index.ts';

/** A type as it is named in manuals and programs, and the order that goes without saying with that name. */
export interface NamedType {
  readonly type: ValueType;
  readonly order?: Order;
}

/** A map from each of the names, with blanks between, to what they all mean. */
const byName = <T>(rows: readonly (readonly [T, string])[]): ReadonlyMap<string, T> =>
  new Map(rows.flatMap(([meant, names]) => names.split(' ').map((name) => [name, meant] as const)));

/** Names of types: those of IEC 61131-3, of C, of masters and gateways. Blanks, hyphens and case do not count. */
const TYPE_NAMES: Readonly<Record<ValueType, string>> = {
  u16: 'u16 uint16 uint unsigned unsigned16 unsignedint unsignedshort ushort word uint16t wordunsigned uword enum16 acc16 count pad',
  i16: 'i16 int16 int signed signed16 signedint short integer integer16 s16 sint16 int16t sword sunssf sshort',
  u32: 'u32 uint32 udint dword unsigned32 unsignedlong ulong uint32t doubleword udword enum32 acc32',
  i32: 'i32 int32 dint signed32 signedlong long integer32 s32 sint32 int32t longint doubleint sdword slong',
  u64: 'u64 uint64 ulint lword unsigned64 unsignedlonglong ulonglong uint64t qword uqword acc64',
  i64: 'i64 int64 lint signed64 longlong s64 sint64 int64t llong sqword',
  f16: 'f16 float16 half halffloat halfprecision',
  f32: 'f32 flt float float32 real real32 single floatingpoint singleprecision ieee754 fp32',
  f64: 'f64 float64 double lreal real64 doubleprecision fp64',
  bcd16: 'bcd bcd16 bcd4 bcd4digits 4digitbcd',
  bcd32: 'bcd32 bcd8 bcd8digits 8digitbcd longbcd lbcd',
  bits: 'bits bitfield binary bitmap flags bitfield16 bitmap16 bool bool16 boolean bit',
  bits32: 'bits32 bitfield32 bitmap32 flags32',
  bits64: 'bits64 bitfield64 bitmap64 flags64',
  text: 'text string ascii char str strg varchar utf8 utf8string visiblestring octetstring characterstring textstring asciistring asciitext',
  latin1: 'latin1 iso88591 windows1252 cp1252 ansi',
  chars: 'chars text16 string16 unicode widestring',
  u8h: 'u8h uint8h u8high uint8high highbyteunsigned uint8msb highbyte hibyte bytehigh',
  u8l: 'u8l u8 uint8 uint8l u8low uint8low usint byte lowbyteunsigned uint8lsb lowbyte lobyte bytelow uint8t uchar unsignedchar',
  i8h: 'i8h int8h i8high int8high int8msb s8h',
  i8l: 'i8l i8 int8 int8l i8low int8low sint int8lsb s8 s8l int8t',
  u24: 'u24 uint24 unsigned24',
  i24: 'i24 int24 signed24 s24',
  u48: 'u48 uint48 unsigned48',
  i48: 'i48 int48 signed48 s48',
  sm16: 'sm16 signandmagnitude signmagnitude signedmagnitude signmagnitude16 signandmagnitude16',
  sm32: 'sm32 signmagnitude32 signandmagnitude32 signedmagnitude32',
  sbcd16: 'sbcd16 sbcd signedbcd signedbcd16 bcds bcdsigned',
  sbcd32: 'sbcd32 signedbcd32 bcdsigned32',
  bcd64: 'bcd64 bcd16digits bcd16digit',
  mod10k2: 'mod10k2 m10k2',
  mod10k3: 'mod10k3 m10k3',
  mod10k4: 'mod10k4 m10k4',
  e8m24: 'e8m24 exponentmantissa decimalfloat',
  timeiec: 'timeiec datetime iec87054 iec8705 ti081 datetimeiec datetime4',
  timeymd: 'timeymd datetime3 ymdhms',
  timemdy: 'timemdy mdyhms',
  timebcd: 'timebcd bcdtime bcddatetime datetimebcd',
  timeunix: 'timeunix unix unixtime epoch unixtimestamp timestamp posixtime timet utc32',
  timeunix64: 'timeunix64 unix64 epoch64 unixtime64',
  timeunixms: 'timeunixms unixms epochms unixtimems unixmilliseconds',
  ip: 'ip ipv4 ipaddr ipaddress ipv4address',
  mac: 'mac eui48 macaddr macaddress',
  pf4q: 'pf4q 4qfppf fourquadrantpowerfactor 4quadrantpowerfactor powerfactor4q 4qpf',
};

export const typeNames: ReadonlyMap<string, NamedType> = byName<NamedType>([
  ...(Object.keys(TYPE_NAMES) as ValueType[]).map((type) => [{ type }, TYPE_NAMES[type]] as const),
  [{ type: 'mod10k4', order: 'CDAB' }, 'mod10 mod10k m10k uint64m10k sint64m10k modulo10000 mod10000'],
  [{ type: 'mod10k2', order: 'CDAB' }, 'um10k sm10k uint32m10k sint32m10k'],
  [{ type: 'mod10k3', order: 'CDAB' }, 'uint48m10k sint48m10k'],
  [{ type: 'f32', order: 'CDAB' }, 'modiconfloat swappedfloat swappedfp floatinverse floatswapped'],
]);

/**
 * Names of byte orders. Little endian is DCBA here, as in programs; some manuals call the order of the registers alone so
 * (CDAB), which is `little endian words`. R0 is the register with the lower address. Digits from 0 (`3-2-1-0`)
 * count from the least significant byte; some makers count from the first byte that is sent.
 */
const ORDER_NAMES: Readonly<Record<Order, readonly string[]>> = {
  ABCD: [
    'abcd ab abcdefgh 1234 3210 bigendian big be motorola network highfirst highwordfirst msb msw',
    'mswfirst msbfirst r0r1 r0r1r2r3 hilo normal notswapped',
  ],
  CDAB: [
    'cdab ghefcdab 3412 1032 wordswap wordswapped swappedwords swapped lowfirst lowwordfirst lsw',
    'lswfirst r1r0 r3r2r1r0 lohi modicon littleendianbyteswap littleendianbyteswapped midlittleendian',
    'littleendianwords littleendianwordorder swap swapwords',
  ],
  BADC: [
    'badc ba badcfehg 2143 2301 byteswap byteswapped swappedbytes swapbytes bigendianbyteswap',
    'bigendianbyteswapped midbigendian',
  ],
  DCBA: [
    'dcba hgfedcba 4321 0123 littleendian little le intel lsb lsbfirst byteandwordswap',
    'wordandbyteswap fullyswapped reversed',
  ],
  CDABGHEF: ['cdabghef r1r0r3r2 wordswapindwords wordswappeddwords'],
  EFGHABCD: ['efghabcd r2r3r0r1 dwordswap dwordswapped lowdwordfirst'],
  DCBAHGFE: ['dcbahgfe'],
  FEHGBADC: ['fehgbadc'],
};

export const orderNames: ReadonlyMap<string, Order> = byName<Order>(
  (Object.keys(ORDER_NAMES) as Order[]).flatMap((order) => ORDER_NAMES[order].map((names) => [order, names] as const)),
);

/** Names of what fills up a text. */
export const paddingNames: ReadonlyMap<string, Padding> = byName<Padding>([
  ['nul', 'nul null zero zeros nulpadded zeropadded'],
  ['blank', 'blank blanks space spaces spacepadded blankpadded'],
]);

/** A name as it is looked up: `Word-Swap` is `wordswap`. */
export const plainName = (name: string): string => name.toLowerCase().replace(/[^\p{L}\p{N}]/gu, '');
