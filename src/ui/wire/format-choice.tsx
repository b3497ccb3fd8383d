import { readSerialFormat, type SerialFormat, serialFormatName, serialFormats } from '../../modbus/index.ts';

interface FormatProps {
  readonly label: string;
  readonly value: SerialFormat;
  readonly onChoose: (format: SerialFormat) => void;
}

/** One of the formats there are. */
export function FormatChoice({ label, value, onChoose }: FormatProps) {
  return (
    <label class="control">
      {label}
      <select
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
    </label>
  );
}
