import './values.css';
import { bitsByByte, namedRows, runsOf } from '../../../../workbench/index.ts';
import type { TabProps } from '../../current-frame.ts';
import { device } from '../../device/naming.ts';
import { useWords } from '../../words.ts';
import { BitList } from './bit-list.tsx';
import { MaskPanel } from './mask-panel.tsx';
import { NamedList } from './named-list.tsx';
import { ValuesPanel } from './values-panel.tsx';

/** What the registers and bits of a frame hold: the device's values by name first. And what its masks do. */
export function ValuesTab({ of }: TabProps) {
  const words = useWords('values');
  const { value: current } = of;
  const { frame } = current;
  const profile = device.value;
  if (frame === undefined) return <p class="said">{words.noValues}</p>;
  const { reading, bytes } = frame;
  const named = profile ? namedRows(profile, reading, bytes) : [];
  const bits = bitsByByte(reading, bytes);
  const hasRegisters = runsOf(reading, bytes).length > 0;
  const { andMask, orMask } = reading.fields;
  const hasMasks = typeof andMask === 'number' && typeof orMask === 'number';
  const isEmpty = named.length === 0 && bits.length === 0 && !hasRegisters && !hasMasks;
  return (
    <div class="values">
      {named.length > 0 && <NamedList rows={named} />}
      {bits.length > 0 && <BitList rows={bits} />}
      {hasRegisters && <ValuesPanel {...current} />}
      {hasMasks && <MaskPanel {...current} />}
      {isEmpty && <p class="said">{words.noValues}</p>}
    </div>
  );
}
