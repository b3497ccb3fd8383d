export { builtInProfiles } from './built-in/index.ts';
export { cellsOf, type RegisterReading, readCells } from './cells.ts';
export { byteOrders, heldValue, valueTypes, wordsOf } from './codec.ts';
export { placeOf as placeOfRegister } from './collect.ts';
export { departure } from './departure.ts';
export {
  type CellFault,
  type Cells,
  type Column,
  columns as registerColumns,
  type LineFault,
  notices as faultNotices,
  type ProfileReading,
  rareColumns as rareRegisterColumns,
  type TableFault,
  type WrittenColumn,
} from './fault.ts';
export { isProfile } from './is-profile.ts';
export { type DeviceFileFault, PROFILE_VERSION, type ProfilesReading, readProfiles, writeProfiles } from './json.ts';
export {
  exactlyInUnits,
  isScaled,
  powerIn,
  ratioText,
  readDecimal,
  readRatio,
  scaleOf,
  withScale,
} from './line-scale.ts';
export { readDevice, writeDevice } from './link-text.ts';
export * from './maps/index.ts';
export { linesAt, type NamedValue, nameAt, namedValues } from './named.ts';
export { saysNothing } from './not-implemented.ts';
export { addressesOf, lineName, printedNumber, stepOf, valueName, valuesOf } from './numbering.ts';
export { type NamedPlace, placesNamed } from './places.ts';
export {
  type Access,
  accesses,
  type Convention,
  conventions,
  deviceUnit,
  type EntityTable,
  entityTables,
  isBitTable,
  isReadOnly,
  type NamedNumber,
  type Profile,
  plainRegister,
  type Register,
  type SerialSettings,
} from './profile.ts';
export {
  canRead,
  canWrite,
  mostRead,
  ownByteCount,
  type ReadRequest,
  type RegisterRequest,
  readRequest,
  readRequests,
  readWithScale,
  writeRequest,
} from './request.ts';
export { type FoundRegister, searchProfile } from './search.ts';
export { readSerial, readTable, type TableRow, writeTable } from './table.ts';
export { coilByteCount, countsValues, isOwnOn, type Trait, takesAnyOn, traits as deviceTraits } from './traits.ts';
export { linesBehind, unitScale } from './units.ts';
export { exactValue, inUnits, namesOf, rawOf } from './values.ts';
