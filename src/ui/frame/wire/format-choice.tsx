import { readSerialFormat, type SerialFormat, serialFormatName, serialFormats } from '../../../modbus/index.ts';

interface FormatProps {
  readonly id: string;
  readonly label: string;
  readonly value: SerialFormat;
  readonly onChoose: (format: SerialFormat) => void;
}

/** One of the formats there are. */
export function FormatChoice({ id, label, value, onChoose }: FormatProps) {
  return (
    <div class="control">
      <label for={id}>{label}</label>
      <select
        id={id}
        value={serialFormatName(value)}
        onChange={({ currentTarget }) => {
          const format = readSerialFormat(currentTarget.value);
          if (format) onChoose(format);
        }}
      >
        {serialFormats.map(serialFormatName).map((name) => (
          <option key={name}>{name}</option>
        ))}
      </select>
    </div>
  );
}
