import { readSerialFormat, type SerialFormat, serialFormatName, serialFormats } from '../../../../modbus/index.ts';
import { Choice } from '../../../kit/choice.tsx';

interface FormatProps {
  readonly id: string;
  readonly label: string;
  readonly value: SerialFormat;
  readonly onChoose: (format: SerialFormat) => void;
}

/** One of the formats there are. */
export function FormatChoice({ id, label, value, onChoose }: FormatProps) {
  return (
    <Choice
      id={id}
      label={label}
      value={serialFormatName(value)}
      options={serialFormats.map(serialFormatName).map((name) => ({ value: name, name }))}
      onChoose={(name) => {
        const format = readSerialFormat(name);
        if (format) onChoose(format);
      }}
    />
  );
}
