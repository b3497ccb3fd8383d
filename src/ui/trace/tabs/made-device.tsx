import { useLayoutEffect, useState } from 'preact/hooks';
import type { Profile } from '../../../devices/index.ts';
import { allDevices, onceCame } from '../../parts/device/chosen.ts';
import { useWords } from '../../parts/words.ts';

/** Keeps a device that was made of a unit, which is the chosen one then, and says so. */
function Made({ profile }: { readonly profile: Profile }) {
  const { values: words } = useWords('trace').tabs;
  const { refusals } = useWords('devices');
  const [made, setMade] = useState<ReturnType<typeof allDevices.add>>();
  useLayoutEffect(() => setMade(allDevices.add(profile)), [profile]);
  if (made === undefined) return null;
  if (typeof made === 'string') return <span class="error">{refusals[made]}</span>;
  return (
    <>
      {words.deviceMade(made.name)} <a href="#devices">{words.editDevice}</a>
    </>
  );
}

export const MadeDevice = onceCame(Made);
