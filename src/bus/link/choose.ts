import type { PortChoice } from './adapters.ts';
import type { LinkState } from './link.ts';

/** A serial port as the browser has it, as far as it is told apart from others. */
export interface Port {
  getInfo(): PortChoice;
}

/** The browser's serial ports: `navigator.serial`, as far as ports are chosen. */
export interface Ports<P extends Port> {
  requestPort(): Promise<P>;
  getPorts(): Promise<readonly P[]>;
}

/** Why a window or worker has no Web Serial; `undefined` if it has. */
export function serialSupport(scope: {
  readonly isSecureContext: boolean;
  readonly navigator: object;
}): Extract<LinkState, { kind: 'unsupported' }> | undefined {
  if ('serial' in scope.navigator) return undefined;
  return { kind: 'unsupported', why: scope.isSecureContext ? 'no-api' : 'insecure' };
}

export type Choice<P> =
  | { readonly kind: 'chosen'; readonly port: P }
  | Extract<LinkState, { readonly kind: 'refused' }>;

/** Lets the person choose a port in the browser's own list; to be called when a button is pressed, in the window. */
export async function choosePort<P extends Port>(serial: Pick<Ports<P>, 'requestPort'>): Promise<Choice<P>> {
  try {
    return { kind: 'chosen', port: await serial.requestPort() };
  } catch (error) {
    const name = error instanceof Error ? error.name : '';
    if (name === 'NotFoundError') return { kind: 'refused', why: 'cancelled' };
    const gesture = error instanceof Error && /gesture/i.test(error.message);
    return { kind: 'refused', why: gesture ? 'no-gesture' : 'policy' };
  }
}

/** The ports that were chosen before and are plugged in; an empty list if a policy forbids asking. */
export async function rememberedPorts<P extends Port>(serial: Pick<Ports<P>, 'getPorts'>): Promise<readonly P[]> {
  try {
    return await serial.getPorts();
  } catch {
    return [];
  }
}

/** The remembered ports that a page cannot tell apart from this one. */
export async function portsLike<P extends Port>(
  serial: Pick<Ports<P>, 'getPorts'>,
  choice: PortChoice,
): Promise<readonly P[]> {
  return (await rememberedPorts(serial)).filter((port) => {
    const info = port.getInfo();
    return (
      info.usbVendorId === choice.usbVendorId &&
      info.usbProductId === choice.usbProductId &&
      info.bluetoothServiceClassId === choice.bluetoothServiceClassId
    );
  });
}
