import { useEffect, useState } from 'preact/hooks';
import type { SerialMode } from '../../../modbus/index.ts';
import { Select } from '../../kit/choice.tsx';
import { disabledFor } from '../../kit/disabled-for.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import { CellsView } from './cells-view.tsx';
import { DeviceList } from './device-list.tsx';
import { FaultForm } from './fault-form.tsx';
import { HeardList } from './heard-list.tsx';
import './virtual.css';

/** Whether the line is the virtual bus. */
const onVirtualBus = (): boolean => {
  const { value: link } = bus.link;
  return link.kind === 'open' && link.adapter.kind === 'virtual';
};

/** The virtual devices, their contents, the faults on request, and who hears each frame. */
export function VirtualPanel() {
  const words = useWords('virtual');
  const devices = bus.virtual.devices.value;
  const lost = bus.virtual.lost.value;
  const [id, choose] = useState(devices[0]?.id);
  const chosen = devices.find((device) => device.id === id) ?? devices[0];
  useEffect(() => () => bus.virtual.watch(undefined), []);
  return (
    <div class="virtual stack">
      <p class="said">{words.intro}</p>
      <ServeBox />
      {lost > 0 && <p class="said error">{words.lost(lost)}</p>}
      <DeviceList chosen={chosen?.id} onChoose={choose} />
      {chosen && <CellsView key={chosen.id} device={chosen} live={onVirtualBus() || bus.serving.value} />}
      <FaultForm />
      <HeardList />
    </div>
  );
}

/** Lets the devices answer on the port that is connected. */
function ServeBox() {
  const text = useWords('virtual').serve;
  const serving = bus.serving.value;
  const possible = bus.connected.value && !onVirtualBus();
  return (
    <section aria-labelledby="virtual-serve">
      <h3 id="virtual-serve">{text.heading}</h3>
      <div class="actions">
        <button type="button" {...disabledFor(possible ? undefined : text.notPort)} onClick={() => bus.serve(!serving)}>
          {serving ? text.stop : text.start}
        </button>
        <label>
          {text.mode}{' '}
          <Select<SerialMode>
            value={bus.rules.value.transport}
            options={[
              { value: 'rtu', name: 'RTU' },
              { value: 'ascii', name: 'ASCII' },
            ]}
            onChoose={(transport) => bus.setRules({ ...bus.rules.value, transport })}
          />
        </label>
      </div>
      <p class="said" role="status">
        {serving ? text.on : possible ? '' : text.notPort}
      </p>
      <p class="said">{possible && text.latency}</p>
    </section>
  );
}
