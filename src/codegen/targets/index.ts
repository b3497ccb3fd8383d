import type { Target } from '../target.ts';
import { arduino } from './arduino.ts';
import { c } from './c.ts';
import { mbpoll, modpoll, printf } from './commands.ts';
import { csharp } from './csharp.ts';
import { framewright } from './framewright.ts';
import { go } from './go.ts';
import { java } from './java.ts';
import { javascript } from './javascript.ts';
import { ladder } from './ladder/ladder.ts';
import { minimalmodbus } from './minimalmodbus.ts';
import { modbusSerial } from './modbus-serial.ts';
import { powershell } from './powershell.ts';
import { pymodbus } from './pymodbus.ts';
import { python } from './python.ts';
import { rockwell } from './rockwell/rockwell.ts';
import { rust } from './rust.ts';
import { scl } from './scl.ts';
import { structuredText } from './structured-text/structured-text.ts';

/** Every target, in the order in which they are offered. */
export const targets: readonly Target[] = [
  structuredText,
  scl,
  rockwell,
  ladder,
  c,
  arduino,
  csharp,
  java,
  go,
  rust,
  python,
  pymodbus,
  minimalmodbus,
  javascript,
  modbusSerial,
  framewright,
  mbpoll,
  modpoll,
  printf,
  powershell,
];
