/**
 * The library under the page: the pure layers, without a DOM, a clock or a network.
 * @module
 */
export * from './devices/index.ts';
export * from './diagnosis/index.ts';
export * from './modbus/index.ts';
export * from './notation/index.ts';
