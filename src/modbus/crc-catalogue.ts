/**
 * How a CRC is worked out. The numbers are as catalogues print them: `poly` without its top bit, and neither it nor
 * `init` reflected.
 */
export interface CrcAlgorithm {
  /** Bits, 1 to 32. */
  readonly width: number;
  readonly poly: number;
  readonly init: number;
  /** Whether each byte goes in with its lowest bit first. */
  readonly refin: boolean;
  /** Whether the register is reflected before `xorout` is applied. */
  readonly refout: boolean;
  readonly xorout: number;
}

/** A CRC that has a name. */
export interface CatalogueCrc<Name extends string = string> extends CrcAlgorithm {
  readonly name: Name;
  readonly aliases: readonly string[];
  /** The CRC of the nine characters `123456789`. */
  readonly check: number;
  /** The register, without `xorout`, after a message and its own CRC. */
  readonly residue: number;
}

/** In the catalogue both `refin` and `refout`, or neither. */
const REFLECTED = true;
const STRAIGHT = false;

/** One row: name, width, poly, init, refin and refout, xorout, check, residue, other names. */
const row = <const Name extends string>(
  name: Name,
  width: number,
  poly: number,
  init: number,
  reflected: boolean,
  xorout: number,
  check: number,
  residue: number,
  ...aliases: readonly string[]
): CatalogueCrc<Name> => ({
  name,
  aliases,
  width,
  poly,
  init,
  refin: reflected,
  refout: reflected,
  xorout,
  check,
  residue,
});

/** Named CRCs in use, by width and name; parameters as in the RevEng catalogue. */
export const crcCatalogue = [
  row('CRC-8/AUTOSAR', 8, 0x2f, 0xff, STRAIGHT, 0xff, 0xdf, 0x42),
  row('CRC-8/BLUETOOTH', 8, 0xa7, 0x00, REFLECTED, 0x00, 0x26, 0x00),
  row('CRC-8/CDMA2000', 8, 0x9b, 0xff, STRAIGHT, 0x00, 0xda, 0x00),
  row('CRC-8/DARC', 8, 0x39, 0x00, REFLECTED, 0x00, 0x15, 0x00),
  row('CRC-8/DVB-S2', 8, 0xd5, 0x00, STRAIGHT, 0x00, 0xbc, 0x00),
  row('CRC-8/GSM-A', 8, 0x1d, 0x00, STRAIGHT, 0x00, 0x37, 0x00),
  row('CRC-8/GSM-B', 8, 0x49, 0x00, STRAIGHT, 0xff, 0x94, 0x53),
  row('CRC-8/HITAG', 8, 0x1d, 0xff, STRAIGHT, 0x00, 0xb4, 0x00),
  row('CRC-8/I-432-1', 8, 0x07, 0x00, STRAIGHT, 0x55, 0xa1, 0xac, 'CRC-8/ITU'),
  row('CRC-8/I-CODE', 8, 0x1d, 0xfd, STRAIGHT, 0x00, 0x7e, 0x00),
  row('CRC-8/LTE', 8, 0x9b, 0x00, STRAIGHT, 0x00, 0xea, 0x00),
  row('CRC-8/MAXIM-DOW', 8, 0x31, 0x00, REFLECTED, 0x00, 0xa1, 0x00, 'DOW-CRC', '1-Wire'),
  row('CRC-8/MIFARE-MAD', 8, 0x1d, 0xc7, STRAIGHT, 0x00, 0x99, 0x00),
  row('CRC-8/NRSC-5', 8, 0x31, 0xff, STRAIGHT, 0x00, 0xf7, 0x00),
  row('CRC-8/OPENSAFETY', 8, 0x2f, 0x00, STRAIGHT, 0x00, 0x3e, 0x00),
  row('CRC-8/ROHC', 8, 0x07, 0xff, REFLECTED, 0x00, 0xd0, 0x00),
  row('CRC-8/SAE-J1850', 8, 0x1d, 0xff, STRAIGHT, 0xff, 0x4b, 0xc4),
  row('CRC-8/SMBUS', 8, 0x07, 0x00, STRAIGHT, 0x00, 0xf4, 0x00, 'CRC-8'),
  row('CRC-8/TECH-3250', 8, 0x1d, 0xff, REFLECTED, 0x00, 0x97, 0x00),
  row('CRC-8/WCDMA', 8, 0x9b, 0x00, REFLECTED, 0x00, 0x25, 0x00),
  row('CRC-16/ARC', 16, 0x8005, 0x0000, REFLECTED, 0x0000, 0xbb3d, 0x0000, 'ARC', 'CRC-16', 'CRC-16/LHA', 'CRC-IBM'),
  row('CRC-16/CDMA2000', 16, 0xc867, 0xffff, STRAIGHT, 0x0000, 0x4c06, 0x0000),
  row('CRC-16/CMS', 16, 0x8005, 0xffff, STRAIGHT, 0x0000, 0xaee7, 0x0000),
  row('CRC-16/DDS-110', 16, 0x8005, 0x800d, STRAIGHT, 0x0000, 0x9ecf, 0x0000),
  row('CRC-16/DECT-R', 16, 0x0589, 0x0000, STRAIGHT, 0x0001, 0x007e, 0x0589),
  row('CRC-16/DECT-X', 16, 0x0589, 0x0000, STRAIGHT, 0x0000, 0x007f, 0x0000),
  row('CRC-16/DNP', 16, 0x3d65, 0x0000, REFLECTED, 0xffff, 0xea82, 0x66c5),
  row('CRC-16/EN-13757', 16, 0x3d65, 0x0000, STRAIGHT, 0xffff, 0xc2b7, 0xa366),
  row('CRC-16/GENIBUS', 16, 0x1021, 0xffff, STRAIGHT, 0xffff, 0xd64e, 0x1d0f),
  row('CRC-16/GSM', 16, 0x1021, 0x0000, STRAIGHT, 0xffff, 0xce3c, 0x1d0f),
  row('CRC-16/IBM-3740', 16, 0x1021, 0xffff, STRAIGHT, 0x0000, 0x29b1, 0x0000, 'CRC-16/CCITT-FALSE', 'CRC-16/AUTOSAR'),
  row('CRC-16/IBM-SDLC', 16, 0x1021, 0xffff, REFLECTED, 0xffff, 0x906e, 0xf0b8, 'X-25', 'CRC-16/ISO-HDLC', 'CRC-B'),
  row('CRC-16/ISO-IEC-14443-3-A', 16, 0x1021, 0xc6c6, REFLECTED, 0x0000, 0xbf05, 0x0000),
  row('CRC-16/KERMIT', 16, 0x1021, 0x0000, REFLECTED, 0x0000, 0x2189, 0x0000, 'CRC-16/CCITT', 'CRC-16/CCITT-TRUE'),
  row('CRC-16/LJ1200', 16, 0x6f63, 0x0000, STRAIGHT, 0x0000, 0xbdf4, 0x0000),
  row('CRC-16/M17', 16, 0x5935, 0xffff, STRAIGHT, 0x0000, 0x772b, 0x0000),
  row('CRC-16/MAXIM-DOW', 16, 0x8005, 0x0000, REFLECTED, 0xffff, 0x44c2, 0xb001, 'CRC-16/MAXIM'),
  row('CRC-16/MCRF4XX', 16, 0x1021, 0xffff, REFLECTED, 0x0000, 0x6f91, 0x0000),
  row('CRC-16/MODBUS', 16, 0x8005, 0xffff, REFLECTED, 0x0000, 0x4b37, 0x0000, 'MODBUS'),
  row('CRC-16/NRSC-5', 16, 0x080b, 0xffff, REFLECTED, 0x0000, 0xa066, 0x0000),
  row('CRC-16/OPENSAFETY-A', 16, 0x5935, 0x0000, STRAIGHT, 0x0000, 0x5d38, 0x0000),
  row('CRC-16/OPENSAFETY-B', 16, 0x755b, 0x0000, STRAIGHT, 0x0000, 0x20fe, 0x0000),
  row('CRC-16/PROFIBUS', 16, 0x1dcf, 0xffff, STRAIGHT, 0xffff, 0xa819, 0xe394),
  row('CRC-16/RIELLO', 16, 0x1021, 0xb2aa, REFLECTED, 0x0000, 0x63d0, 0x0000),
  row('CRC-16/SPI-FUJITSU', 16, 0x1021, 0x1d0f, STRAIGHT, 0x0000, 0xe5cc, 0x0000, 'CRC-16/AUG-CCITT'),
  row('CRC-16/T10-DIF', 16, 0x8bb7, 0x0000, STRAIGHT, 0x0000, 0xd0db, 0x0000),
  row('CRC-16/TELEDISK', 16, 0xa097, 0x0000, STRAIGHT, 0x0000, 0x0fb3, 0x0000),
  row('CRC-16/TMS37157', 16, 0x1021, 0x89ec, REFLECTED, 0x0000, 0x26b1, 0x0000),
  row('CRC-16/UMTS', 16, 0x8005, 0x0000, STRAIGHT, 0x0000, 0xfee8, 0x0000, 'CRC-16/BUYPASS', 'CRC-16/VERIFONE'),
  row('CRC-16/USB', 16, 0x8005, 0xffff, REFLECTED, 0xffff, 0xb4c8, 0xb001),
  row('CRC-16/XMODEM', 16, 0x1021, 0x0000, STRAIGHT, 0x0000, 0x31c3, 0x0000, 'ZMODEM', 'CRC-16/ACORN'),
  row('CRC-32/AIXM', 32, 0x814141ab, 0x00000000, STRAIGHT, 0x00000000, 0x3010bf7f, 0x00000000),
  row('CRC-32/AUTOSAR', 32, 0xf4acfb13, 0xffffffff, REFLECTED, 0xffffffff, 0x1697d06a, 0x904cddbf),
  row('CRC-32/BASE91-D', 32, 0xa833982b, 0xffffffff, REFLECTED, 0xffffffff, 0x87315576, 0x45270551),
  row('CRC-32/BZIP2', 32, 0x04c11db7, 0xffffffff, STRAIGHT, 0xffffffff, 0xfc891918, 0xc704dd7b, 'CRC-32/AAL5'),
  row('CRC-32/CD-ROM-EDC', 32, 0x8001801b, 0x00000000, REFLECTED, 0x00000000, 0x6ec2edc4, 0x00000000),
  row('CRC-32/CKSUM', 32, 0x04c11db7, 0x00000000, STRAIGHT, 0xffffffff, 0x765e7680, 0xc704dd7b, 'CKSUM', 'POSIX'),
  row(
    'CRC-32/ISCSI',
    32,
    0x1edc6f41,
    0xffffffff,
    REFLECTED,
    0xffffffff,
    0xe3069283,
    0xb798b438,
    'CRC-32C',
    'CRC-32/CASTAGNOLI',
  ),
  row('CRC-32/ISO-HDLC', 32, 0x04c11db7, 0xffffffff, REFLECTED, 0xffffffff, 0xcbf43926, 0xdebb20e3, 'CRC-32', 'PKZIP'),
  row('CRC-32/JAMCRC', 32, 0x04c11db7, 0xffffffff, REFLECTED, 0x00000000, 0x340bc6d9, 0x00000000),
  row('CRC-32/MEF', 32, 0x741b8cd7, 0xffffffff, REFLECTED, 0x00000000, 0xd2c22f51, 0x00000000),
  row('CRC-32/MPEG-2', 32, 0x04c11db7, 0xffffffff, STRAIGHT, 0x00000000, 0x0376e6e7, 0x00000000),
  row('CRC-32/XFER', 32, 0x000000af, 0x00000000, STRAIGHT, 0x00000000, 0xbd0be338, 0x00000000),
];

export type CrcName = (typeof crcCatalogue)[number]['name'];
