/** Ours first, then those it is measured against. Each is a file in peers/. */
export const programs = ['framewright', 'crc', 'modbus-serial', 'jsmodbus', 'modbus-pdu', 'modbus-webserial'];

/**
 * How a program does one thing.
 * @typedef {object} Measured
 * @property {(input: any) => any} run what is timed
 * @property {(input: any) => any} [prepare] turns an input into the type the program wants; not timed
 * @property {(result: any) => Iterable<number>} [registers] takes the registers out of a decoded reply; not timed
 * @property {boolean} [pduOnly] the program makes the PDU alone, without unit identifier and CRC
 * @property {string} [note] what the reader of the numbers must know
 *
 * @typedef {Partial<Record<'crc16' | 'encode03' | 'encode10' | 'decode10' | 'decode100', Measured>>} Peer
 */

/** @returns {Promise<Peer>} */
export const loadPeer = (program) => import(`./peers/${program}.mjs`);
