// The calculator itself: the package's main function copies its input into a new Buffer first.
import calculate from 'crc/calculators/crc16modbus';

export const crc16 = {
  run: (bytes) => calculate(bytes),
  note: 'its calculator, without the copy its main function makes',
};
