/** What a link goes through. */
export interface Adapter {
  readonly kind: 'usb' | 'bluetooth' | 'port' | 'virtual';
  /** USB numbers, if it is a USB adapter. */
  readonly vendorId?: number;
  readonly productId?: number;
  /** The company's name and the chip's, as far as they are known. */
  readonly maker?: string;
  readonly chip?: string;
}

/** What identifies a port in every window and worker. Two adapters of one kind cannot be told apart by it. */
export interface PortChoice {
  readonly usbVendorId?: number | undefined;
  readonly usbProductId?: number | undefined;
  readonly bluetoothServiceClassId?: number | string | undefined;
}

interface Maker {
  readonly maker: string;
  /** By product number; other products of the company are not named. */
  readonly chips: Readonly<Record<number, string>>;
}

/** By USB vendor number: those of the Linux kernel's usb-serial drivers, and boards that PLC people meet. */
const MAKERS: Readonly<Record<number, Maker>> = {
  1027: {
    maker: 'FTDI',
    chips: {
      24577: 'FT232R',
      24592: 'FT2232',
      24593: 'FT4232H',
      24596: 'FT232H',
      24597: 'FT230X',
    },
  },
  6790: {
    maker: 'WCH',
    chips: {
      21795: 'CH341',
      29986: 'CH340',
      29987: 'CH340',
      21970: 'CH342',
      21971: 'CH343',
      21972: 'CH9102',
      21973: 'CH344',
      21976: 'CH9101',
    },
  },
  4292: {
    maker: 'Silicon Labs',
    chips: { 60000: 'CP210x', 60001: 'CP210x', 60003: 'CP210x', 60016: 'CP2105', 60017: 'CP2108' },
  },
  1659: {
    maker: 'Prolific',
    chips: {
      8963: 'PL2303',
      8964: 'PL2303',
      9123: 'PL2303GC',
      9139: 'PL2303GB',
      9155: 'PL2303GT',
      9171: 'PL2303GL',
      9187: 'PL2303GE',
      9203: 'PL2303GS',
    },
  },
  1250: { maker: 'MaxLinear', chips: { 5136: 'XR21V1410', 5138: 'XR21V1412', 5140: 'XR21V1414' } },
  4362: { maker: 'Moxa', chips: { 4368: 'UPort 1110', 4400: 'UPort 1130', 4432: 'UPort 1150', 4433: 'UPort 1150I' } },
  1105: { maker: 'Texas Instruments', chips: { 13328: 'TUSB3410' } },
  1240: { maker: 'Microchip', chips: { 10: 'CDC', 221: 'MCP2221' } },
  9025: { maker: 'Arduino', chips: {} },
  11914: { maker: 'Raspberry Pi', chips: {} },
  12346: { maker: 'Espressif', chips: { 4097: 'ESP32 USB' } },
  1155: { maker: 'STMicroelectronics', chips: { 22336: 'CDC', 14155: 'ST-Link' } },
};

/** The adapter with these USB numbers; a port without any is one of the computer itself, or Bluetooth. */
export function adapterOf(info: PortChoice): Adapter {
  const { usbVendorId: vendorId, usbProductId: productId } = info;
  if (vendorId === undefined) return { kind: info.bluetoothServiceClassId === undefined ? 'port' : 'bluetooth' };
  const known = MAKERS[vendorId];
  const chip = productId === undefined ? undefined : known?.chips[productId];
  return {
    kind: 'usb',
    vendorId,
    ...(productId !== undefined && { productId }),
    ...(known && { maker: known.maker }),
    ...(chip !== undefined && { chip }),
  };
}
