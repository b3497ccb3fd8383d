import { expect, test } from 'vitest';
import { readSheets } from '../../../../src/devices/maps/read-sheets.ts';

const read = (source: unknown, name?: string) =>
  readSheets(typeof source === 'string' ? source : JSON.stringify(source), name);
/** The rows of all sheets by their headers, without what is empty. */
const registers = (source: unknown, name?: string) =>
  read(source, name).sheets.flatMap(({ rows: [header, ...rows] }) =>
    rows.map(({ cells }) =>
      Object.fromEntries(
        cells.map((cell, index) => [header?.cells[index], cell] as const).filter(([, cell]) => cell !== ''),
      ),
    ),
  );
const facts = (source: unknown) => read(source).sheets.map((sheet) => sheet.facts);

test('SunSpec: points follow each other from the start of the model, scale factors are registers', () => {
  const model = {
    id: 103,
    group: {
      name: 'inverter',
      label: 'Inverter',
      points: [
        { name: 'ID', size: 1, type: 'uint16', value: 103 },
        { name: 'L', size: 1, type: 'uint16' },
        { name: 'A', label: 'Amps', desc: 'AC current', size: 1, type: 'uint16', sf: 'A_SF', units: 'A' },
        { name: 'WH', size: 2, type: 'acc32', sf: -2, units: 'Wh', access: 'RW' },
        { name: 'A_SF', size: 1, type: 'sunssf' },
        {
          name: 'Evt',
          size: 2,
          type: 'bitfield32',
          symbols: [
            { name: 'GROUND_FAULT', value: 0 },
            { name: 'OVER_TEMP', value: 7 },
          ],
        },
        { name: 'SN', size: 16, type: 'string' },
      ],
      groups: [
        {
          name: 'module',
          count: 2,
          points: [
            { name: 'DCA', size: 1, type: 'uint16', sf: 'A_SF' },
            { name: 'Tmp', size: 1, type: 'int16' },
          ],
        },
      ],
    },
  };
  expect(facts(model)).toEqual([
    { table: 'holding-register', counting: 'zero', order: 'ABCD', relative: 'true', device: 'Inverter (103)' },
  ]);
  expect(registers(model).slice(2)).toEqual([
    {
      name: 'A',
      address: '2',
      type: 'uint16',
      'not implemented': '0xFFFF',
      'count of registers': '1',
      'scale factor register': '5',
      unit: 'A',
      access: 'R',
      description: 'Amps: AC current',
    },
    { name: 'WH', address: '3', type: 'acc32', 'count of registers': '2', factor: '0.01', unit: 'Wh', access: 'RW' },
    { name: 'A_SF', address: '5', type: 'sunssf', 'not implemented': '0x8000', 'count of registers': '1', access: 'R' },
    {
      name: 'Evt',
      address: '6',
      type: 'bitfield32',
      'not implemented': '0xFFFFFFFF',
      'count of registers': '2',
      access: 'R',
      names: '0=GROUND_FAULT; 7=OVER_TEMP',
    },
    { name: 'SN', address: '8', type: 'string', 'count of registers': '16', access: 'R' },
    {
      name: 'DCA',
      address: '24',
      type: 'uint16',
      'not implemented': '0xFFFF',
      'count of registers': '1',
      'scale factor register': '5',
      access: 'R',
      group: 'module 1',
    },
    {
      name: 'Tmp',
      address: '25',
      type: 'int16',
      'not implemented': '0x8000',
      'count of registers': '1',
      access: 'R',
      group: 'module 1',
    },
    {
      name: 'DCA',
      address: '26',
      type: 'uint16',
      'not implemented': '0xFFFF',
      'count of registers': '1',
      'scale factor register': '5',
      access: 'R',
      group: 'module 2',
    },
    {
      name: 'Tmp',
      address: '27',
      type: 'int16',
      'not implemented': '0x8000',
      'count of registers': '1',
      access: 'R',
      group: 'module 2',
    },
  ]);
  expect(read([model, model]).sheets).toHaveLength(2);
});

test('Home Assistant: sensors, bits, switches and climates of a hub', () => {
  const text = `
modbus:
  - name: heat pump
    type: tcp
    host: 192.0.2.1
    port: 502
    sensors:
      - name: Flow
        slave: 1
        address: 0x0010
        input_type: input
        scale: 0.1
        offset: -40
        precision: 1
        unit_of_measurement: °C
        nan_value: 0x8000
        swap: none
      - name: Energy
        device_address: 1
        address: 20
        data_type: float32
        swap: word
        virtual_count: 2
      - name: Serial
        address: 40
        slave: 1
        data_type: string
        count: 8
    binary_sensors:
      - name: Fault
        slave: 1
        address: 3
        input_type: discrete_input
    switches:
      - name: Pump
        slave: 1
        address: 7
        write_type: coil
        command_on: 1
        command_off: 0
    climates:
      - name: Room
        slave: 1
        address: 30
        input_type: input
        data_type: int16
        scale: 0.1
        target_temp_register: 31
        hvac_mode_register:
          address: 32
          values:
            state_off: 0
            state_heat: 4
`;
  expect(read(text).format).toBe('home-assistant');
  expect(facts(text)).toEqual([{ counting: 'zero', order: 'ABCD', device: 'heat pump', unit: '1' }]);
  expect(registers(text)).toEqual([
    {
      name: 'Flow',
      address: '0x0010',
      table: 'input-register',
      type: 'int16',
      factor: '0.1',
      offset: '-40',
      decimals: '1',
      'not implemented': '0x8000',
      unit: '°C',
      group: 'sensors',
    },
    {
      name: 'Energy',
      address: '20',
      table: 'holding-register',
      type: 'float32',
      'word order': 'CDAB',
      count: '3',
      group: 'sensors',
    },
    {
      name: 'Serial',
      address: '40',
      table: 'holding-register',
      type: 'string',
      'count of registers': '8',
      group: 'sensors',
    },
    { name: 'Fault', address: '3', table: 'discrete-input', type: 'bool', group: 'binary_sensors' },
    { name: 'Pump', address: '7', table: 'coil', type: 'bool', names: '0=off; 1=on', group: 'switches' },
    { name: 'Room', address: '30', table: 'input-register', type: 'int16', factor: '0.1', group: 'climates' },
    { name: 'Room target', address: '31', table: 'holding-register', type: 'int16', factor: '0.1', group: 'climates' },
    {
      name: 'Room mode',
      address: '32',
      table: 'holding-register',
      type: 'uint16',
      names: '0=state_off; 4=state_heat',
      group: 'climates',
    },
  ]);
  const hubs = text.replace('\nmodbus:', '').replaceAll('\n  ', '\n');
  expect(registers(hubs)).toHaveLength(8);
  expect(registers(`my_package:${text.replaceAll('\n', '\n  ')}`)).toHaveLength(8);
});

test('ESPHome: entities of the platform modbus_controller', () => {
  const text = `
sensor:
  - platform: modbus_controller
    modbus_controller_id: epever
    name: "Voltage"
    address: 0x3100
    register_type: read
    value_type: U_WORD
    unit_of_measurement: "V"
    accuracy_decimals: 1
    filters:
      - offset: 2
      - multiply: 0.01
  - platform: modbus_controller
    name: Low
    address: 0x200
    register_type: holding
    value_type: U_DWORD_R
    bitmask: 0xFF00
    offset: 4
  - platform: uptime
    name: Uptime
text_sensor:
  - platform: modbus_controller
    name: Clock
    address: 0x9013
    register_type: holding
    register_count: 3
    response_size: 6
number:
  - platform: modbus_controller
    name: Limit
    address: 0x9001
    multiply: 100
switch:
  - platform: modbus_controller
    id: pump
    register_type: coil
    address: 2
select:
  - platform: modbus_controller
    name: Mode
    address: 1000
    value_type: U_WORD
    optionsmap:
      "Auto": 1
      "Off, all": 0
`;
  expect(read(text).format).toBe('esphome');
  expect(registers(text)).toEqual([
    {
      name: 'Voltage',
      address: '0x3100',
      table: 'input-register',
      type: 'U_WORD',
      factor: '0.01',
      offset: '0.02',
      decimals: '1',
      unit: 'V',
      group: 'sensor',
    },
    { name: 'Low', address: '514', table: 'holding-register', type: 'U_DWORD_R', mask: '0xFF00', group: 'sensor' },
    {
      name: 'Clock',
      address: '0x9013',
      table: 'holding-register',
      type: 'string',
      'count of registers': '3',
      group: 'text_sensor',
    },
    { name: 'Limit', address: '0x9001', table: 'holding-register', type: 'U_WORD', divisor: '100', group: 'number' },
    { name: 'pump', address: '2', table: 'coil', type: 'bool', group: 'switch' },
    {
      name: 'Mode',
      address: '1000',
      table: 'holding-register',
      type: 'U_WORD',
      names: '1=Auto; 0=Off, all',
      group: 'select',
    },
  ]);
});

test('evcc: each use of a template, described by the comment behind the address', () => {
  const text = `template: my-meter
products:
  - brand: X
params:
  - name: usage
    choice: ["grid", "pv"]
  - name: maxpower
    service: modbus/read?address=30075&type=holding&encoding=uint32&scale=0.001&{modbus}
render: |
  type: custom
  {{- if eq .usage "grid" }}
  power:
    source: modbus
    {{- include "modbus" . | indent 2 }}
    register:
      address: 40073 # Power of the grid
      type: holding
      decode: int32s
    scale: -1
  {{- else if eq .usage "pv" }}
  power:
    source: calc
    add:
    - source: modbus
      uri: {{ joinHostPort .host .port }}
      register:
        type: input
        decode: uint32nan
        address: 1
  {{- end }}
  soc:
    source: modbus
    register:
      address: 5
      type: writesingle
      encoding: uint16
`;
  expect(read(text).format).toBe('evcc');
  expect(facts(text)).toEqual([{ counting: 'zero', device: 'my-meter' }]);
  expect(registers(text)).toEqual([
    { name: 'soc', address: '5', table: 'holding-register', type: 'uint16', access: 'w' },
    {
      name: 'power',
      address: '40073',
      table: 'holding-register',
      type: 'int32',
      'word order': 'CDAB',
      factor: '-1',
      group: 'grid',
      description: 'Power of the grid',
    },
    {
      name: 'power 1',
      address: '1',
      table: 'input-register',
      type: 'uint32',
      'word order': 'ABCD',
      'not implemented': '0xFFFFFFFF',
      group: 'pv',
    },
    {
      name: 'maxpower',
      address: '30075',
      table: 'holding-register',
      type: 'uint32',
      'word order': 'ABCD',
      factor: '0.001',
      group: 'params',
    },
  ]);
});

test('evcc: a meter of a configuration has its name', () => {
  const text =
    'meters:\n- name: grid\n  type: custom\n  power:\n    source: modbus\n    register:\n      address: 28\n      type: input\n      decode: float32\n';
  expect(registers(text)).toEqual([
    { name: 'meters grid power', address: '28', table: 'input-register', type: 'float32', 'word order': 'ABCD' },
  ]);
});

test.each([
  ['uint64snan', { type: 'uint64', 'word order': 'CDAB', 'not implemented': '0xFFFFFFFFFFFFFFFF' }],
  ['float32nans', { type: 'float32', 'word order': 'CDAB', 'not implemented': 'NaN' }],
  ['int16nan', { type: 'int16', 'not implemented': '0x8000' }],
  ['ieee754s', { type: 'float32', 'word order': 'CDAB' }],
  ['float64', { type: 'float64', 'word order': 'ABCD' }],
  ['bool16', { type: 'bool' }],
])('evcc: decodes %s', (decode, cells) => {
  const plugin = { source: 'modbus', register: { address: 7, type: 'holding', decode } };
  expect(registers({ power: plugin })).toEqual([{ name: 'power', address: '7', table: 'holding-register', ...cells }]);
});

test('Telegraf: by register and by request', () => {
  const text = `# a comment
[agent]
  interval = "10s"

[[inputs.modbus]]
  name = "Device \\"1\\""
  slave_id = 3
  controller = 'tcp://localhost:502' # here
  coils = [
    { name = "Motor", address = [0]},
  ]
  holding_registers = [
    { name = "PowerFactor", byte_order = "AB",   data_type = "FIXED", scale=0.01,  address = [8]},
    { name = "Energy",      byte_order = "ABCD", data_type = "FLOAT32", scale=0.001, address = [5,6]}, # kWh
    { name = "Frequency", byte_order="CDAB", data_type="FLOAT32-IEEE", scale=1.0, address=[7, 8] }
  ]

[[inputs.modbus]]
  [[inputs.modbus.request]]
    slave_id = 4
    byte_order = "DCBA"
    register = "input"
    fields = [
      { address=0, type="INT16", name="temperature", scale=0.1 },
      { address=2, type="STRING", name="text", length=4 },
      { address=9, type="BIT", name="flag", bit=3 },
    ]
  [inputs.modbus.request.tags]
    machine = "x"
`;
  expect(read(text).format).toBe('telegraf');
  expect(facts(text)).toEqual([
    { counting: 'zero', device: 'Device "1"', unit: '3' },
    { counting: 'zero', unit: '4' },
  ]);
  expect(registers(text)).toEqual([
    { name: 'Motor', address: '0', table: 'coil', type: 'bool' },
    { name: 'PowerFactor', address: '8', table: 'holding-register', type: 'INT16', 'word order': 'AB', factor: '0.01' },
    { name: 'Energy', address: '5', table: 'holding-register', type: 'UINT32', 'word order': 'ABCD', factor: '0.001' },
    {
      name: 'Frequency',
      address: '7',
      table: 'holding-register',
      type: 'FLOAT32',
      'word order': 'CDAB',
      factor: '1.0',
    },
    { name: 'temperature', address: '0', table: 'input-register', type: 'INT16', 'word order': 'DCBA', factor: '0.1' },
    {
      name: 'text',
      address: '2',
      table: 'input-register',
      type: 'STRING',
      'word order': 'DCBA',
      'count of registers': '4',
    },
    { name: 'flag', address: '9', table: 'input-register', type: 'BIT', 'word order': 'DCBA', bit: '3' },
  ]);
});

test('ThingsBoard: time series, attributes and what is written', () => {
  const config = {
    master: {
      slaves: [
        {
          unitId: 1,
          deviceName: 'Meter',
          byteOrder: 'BIG',
          wordOrder: 'LITTLE',
          timeseries: [{ tag: 'energy', type: '32uint', functionCode: 4, objectsCount: 2, address: 6, divider: 10 }],
          attributes: [
            { tag: 'serial', type: 'string', functionCode: 3, objectsCount: 4, address: 40 },
            { tag: 'bits', type: 'bits', functionCode: 1, objectsCount: 3, address: 0 },
          ],
          attributeUpdates: [
            { tag: 'limit', type: '16int', functionCode: 6, objectsCount: 1, address: 10, multiplier: 10 },
          ],
        },
      ],
    },
  };
  expect(facts(config)).toEqual([{ counting: 'zero', order: 'CDAB', device: 'Meter', unit: '1' }]);
  expect(registers(config)).toEqual([
    {
      name: 'energy',
      address: '6',
      table: 'input-register',
      type: 'uint32',
      divisor: '10',
      access: 'r',
      group: 'timeseries',
    },
    {
      name: 'serial',
      address: '40',
      table: 'holding-register',
      type: 'string',
      'count of registers': '4',
      access: 'r',
      group: 'attributes',
    },
    { name: 'bits', address: '0', table: 'coil', type: 'bool', count: '3', access: 'r', group: 'attributes' },
    {
      name: 'limit',
      address: '10',
      table: 'holding-register',
      type: 'int16',
      factor: '10',
      access: 'w',
      group: 'attributeUpdates',
    },
  ]);
  expect(read({ Modbus: { configurationJson: config } }).format).toBe('thingsboard');
});

test('nymea: registers and blocks, enumerations, and exponents', () => {
  const map = {
    className: 'Pump',
    endianness: 'LittleEndian',
    enums: [
      {
        name: 'Mode',
        values: [
          { key: 'Off', value: 0 },
          { key: 'Heat', value: 4 },
        ],
      },
    ],
    registers: [
      { id: 'mode', address: 3, size: 1, type: 'uint16', registerType: 'holdingRegister', enum: 'Mode', access: 'RW' },
    ],
    blocks: [
      {
        id: 'power',
        registers: [
          {
            id: 'total',
            address: 52,
            size: 2,
            type: 'float',
            registerType: 'inputRegister',
            description: 'Total power',
            unit: 'W',
            access: 'RO',
            scaleFactor: 'exponent',
          },
          {
            id: 'exponent',
            address: 54,
            size: 1,
            type: 'int16',
            registerType: 'inputRegister',
            staticScaleFactor: -3,
            access: 'RO',
          },
        ],
      },
    ],
  };
  expect(facts(map)).toEqual([{ counting: 'zero', order: 'CDAB', device: 'Pump' }]);
  expect(registers(map)).toEqual([
    {
      name: 'mode',
      address: '3',
      table: 'holdingRegister',
      type: 'uint16',
      'count of registers': '1',
      access: 'RW',
      names: '0=Off; 4=Heat',
    },
    {
      name: 'total',
      address: '52',
      table: 'inputRegister',
      type: 'float',
      'count of registers': '2',
      'scale factor register': '54',
      unit: 'W',
      access: 'RO',
      group: 'power',
      description: 'Total power',
    },
    {
      name: 'exponent',
      address: '54',
      table: 'inputRegister',
      type: 'int16',
      'count of registers': '1',
      factor: '0.001',
      access: 'RO',
      group: 'power',
    },
  ]);
});

test('SunGather: two lists for two tables, counted from one, and values by their answer', () => {
  const text = `
version: 0.2.4
vendor: Sungrow
registers:
  - read:
    - name: "state"
      level: 1
      address: 5038
      datatype: "U16"
      datarange:
        - response: 0x0
          value: "Run"
        - response: 0x8000
          value: "Stop"
    - name: serial
      address: 4990
      datatype: "UTF-8"
      models: ["A", "B"]
  - hold:
    - name: power
      address: 5008
      datatype: "S32"
      accuracy: 0.1
      unit: kW
scan:
  - read:
    - start: 4949
      range: 10
`;
  expect(facts(text)).toEqual([
    { table: 'input-register', counting: 'one', order: 'CDAB', device: 'Sungrow' },
    { table: 'holding-register', counting: 'one', order: 'CDAB', device: 'Sungrow' },
  ]);
  expect(registers(text)).toEqual([
    { name: 'state', address: '5038', type: 'U16', names: '0x0=Run; 0x8000=Stop' },
    { name: 'serial', address: '4990', type: 'UTF-8', 'count of registers': '10', model: 'A, B' },
    { name: 'power', address: '5008', type: 'S32', factor: '0.1', unit: 'kW' },
  ]);
});

test('ioBroker: tab-separated lists, whose types have their order', () => {
  const text =
    '_address\tname\tdescription\tunit\ttype\tlen\tfactor\toffset\tformula\trole\n40001\tU\tVoltage L1\tV\tuint16be\t1\t0.1\t0\t\tvalue\n40002\tE\t\tkWh\tfloatsw\t2\t1\t0\tx*2\tvalue\n40010\tSN\t\t\tstring\t8\t1\t0\t\t\n';
  expect(read(text).format).toBe('iobroker');
  expect(registers(text)).toEqual([
    {
      name: 'U',
      address: '40001',
      type: 'uint16',
      'word order': 'ABCD',
      'count of registers': '1',
      factor: '0.1',
      offset: '0',
      unit: 'V',
      description: 'Voltage L1',
    },
    {
      name: 'E',
      address: '40002',
      type: 'float',
      'word order': 'CDAB',
      'count of registers': '2',
      factor: '1',
      offset: '0',
      unit: 'kWh',
      description: 'x*2',
    },
    { name: 'SN', address: '40010', type: 'string', 'count of registers': '8', factor: '1', offset: '0' },
  ]);
  expect(read(text).sheets[0]?.rows.map(({ line }) => line)).toEqual([1, 2, 3, 4]);
});

test('Kepware: tags with linear scaling', () => {
  const text = `Tag Name,Address,Data Type,Respect Data Type,Client Access,Scan Rate,Scaling,Raw Low,Raw High,Scaled Low,Scaled High,Scaled Data Type,Clamp Low,Clamp High,Eng Units,Description,Negate Value
"Tank.Level",400001,Word,1,R/W,100,Linear,0,1000,-50,50,Double,0,0,%,"Level, left",0
"Run",000005,Boolean,1,RO,100,,,,,,,,,,"",
"Serial",400010.20H,String,1,RO,100,None,,,,,,,,,"",
`;
  expect(read(text).format).toBe('kepware');
  expect(registers(text)).toEqual([
    {
      name: 'Tank.Level',
      address: '400001',
      type: 'Word',
      factor: '0.1',
      offset: '-50',
      unit: '%',
      access: 'R/W',
      description: 'Level, left',
    },
    { name: 'Run', address: '000005', type: 'Boolean', access: 'RO' },
    { name: 'Serial', address: '400010.20H', type: 'String', access: 'RO' },
  ]);
});
