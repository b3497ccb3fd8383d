import type { NameRules } from '../names.ts';

const KEYWORDS = `False None True and as assert async await break case class continue def del elif else except finally for from
global if import in is lambda match nonlocal not or pass raise return try type while with yield`;

/** Functions and types that are always there: hiding one is legal, and makes the next reader look twice. */
const BUILT_IN = `abs aiter all anext any ascii bin bool breakpoint bytearray bytes callable chr classmethod compile complex copyright
credits delattr dict dir divmod enumerate eval exec exit filter float format frozenset getattr globals hasattr hash help hex id
input int isinstance issubclass iter len license list locals map max memoryview min next object oct open ord pow print property
quit range repr reversed round set setattr slice sorted staticmethod str sum super tuple type vars zip`;

/** Modules, and what the programs define themselves. */
const OWN = `Callable FramerType ModbusException ModbusSerialClient ModbusTcpClient OSError TimeoutError Failed math minimalmodbus
pymodbus serial socket struct sys time HOST PORT BAUD DATA_BITS PARITY STOP_BITS PAUSE SILENCE TIMEOUT exchange finish main send
steps verdict wait_until frame line self`;

export const pythonRules: NameRules = {
  styles: { routine: 'snake', variable: 'snake', constant: 'constant', table: 'constant', type: 'pascal' },
  reserved: `${KEYWORDS} ${BUILT_IN} ${OWN}`.split(/\s+/),
};
