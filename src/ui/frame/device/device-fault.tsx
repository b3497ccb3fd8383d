import { download } from '../../kit/download.ts';
import { allDevices } from '../../parts/device/chosen.ts';
import { useWords } from '../../parts/words.ts';

/** Stored devices that cannot be used. Nothing is thrown away. */
export function DeviceFault({ onMessage }: { onMessage: (message: string) => void }) {
  const words = useWords('devices');
  const { list } = allDevices;
  const { value } = list.stored;
  if (value.kind === 'refused') return <p class="device-fault">{words.refusals.refused}</p>;
  if (value.kind === 'list') {
    if (value.bad.length === 0) return null;
    return (
      <div class="device-fault">
        <p>{words.badProfiles(value.bad.length)}</p>
        {value.bad.map(({ name, fault }, index) => (
          <p key={index}>{words.badProfile(name, fault)}</p>
        ))}
      </div>
    );
  }
  return (
    <p class="device-fault">
      {words.unreadable(value.fault)}{' '}
      <button type="button" onClick={() => download(value.text, 'framewright-devices.json')}>
        {words.download}
      </button>{' '}
      <button
        type="button"
        onClick={() => {
          const outcome = list.setUnreadableAside();
          onMessage(typeof outcome === 'string' ? words.refusals[outcome] : words.setAsideAs(outcome.key));
        }}
      >
        {words.setAside}
      </button>
    </p>
  );
}
