import type { LinkState } from './link.ts';

/** Why a window or worker has no Web Serial; `undefined` if it has. */
export function serialSupport(scope: {
  readonly isSecureContext: boolean;
  readonly navigator: object;
}): Extract<LinkState, { kind: 'unsupported' }> | undefined {
  if ('serial' in scope.navigator) return undefined;
  return { kind: 'unsupported', why: scope.isSecureContext ? 'no-api' : 'insecure' };
}

export type Choice =
  | { readonly kind: 'chosen'; readonly port: SerialPort }
  | Extract<LinkState, { readonly kind: 'refused' }>;

/** Lets the person choose a port in the browser's own list; to be called when a button is pressed, in the window. */
export async function choosePort(serial: Serial, filters: SerialPortFilter[] = []): Promise<Choice> {
  try {
    return { kind: 'chosen', port: await serial.requestPort(filters.length > 0 ? { filters } : {}) };
  } catch (error) {
    const name = error instanceof Error ? error.name : '';
    if (name === 'NotFoundError') return { kind: 'refused', why: 'cancelled' };
    const gesture = error instanceof Error && /gesture/i.test(error.message);
    return { kind: 'refused', why: gesture ? 'no-gesture' : 'policy' };
  }
}

/** The ports that were chosen before and are plugged in; an empty list if a policy forbids asking. */
export async function rememberedPorts(serial: Serial): Promise<readonly SerialPort[]> {
  try {
    return await serial.getPorts();
  } catch {
    return [];
  }
}

/** What identifies a port in every window and worker. Two adapters of one kind cannot be told apart by it. */
export type PortChoice = Readonly<ReturnType<SerialPort['getInfo']>>;

/** The remembered ports that a page cannot tell apart from this one. */
export async function portsLike(serial: Serial, choice: PortChoice): Promise<readonly SerialPort[]> {
  return (await rememberedPorts(serial)).filter((port) => {
    const info = port.getInfo();
    return (
      info.usbVendorId === choice.usbVendorId &&
      info.usbProductId === choice.usbProductId &&
      info.bluetoothServiceClassId === choice.bluetoothServiceClassId
    );
  });
}
