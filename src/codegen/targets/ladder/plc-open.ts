import { type Rung, xmlText } from './rung.ts';

/** The project of PLCopen TC6, version 2.01, with one program in ladder. */
export function plcOpen(rungs: readonly Rung[]): string {
  const variables = rungs.flatMap(({ contact, coils, instance, block }) => [
    variable(contact, '<BOOL/>'),
    ...coils.map(([, coil]) => variable(coil, '<BOOL/>')),
    variable(instance, `<derived name="${xmlText(block)}"/>`),
  ]);
  const passed = new Map(rungs.flatMap(({ passed }) => passed));
  for (const [name, type] of passed)
    variables.push(variable(name, type === 'DINT' ? '<DINT/>' : `<derived name="${type}"/>`));
  const scaling = (language: string) => `        <${language}><scaling x="1" y="1"/></${language}>`;
  return [
    '<?xml version="1.0" encoding="utf-8"?>',
    '<project xmlns="http://www.plcopen.org/xml/tc6_0201">',
    // The date is required, and the same for the same program.
    '  <fileHeader companyName="" productName="Framewright" productVersion="1" creationDateTime="2000-01-01T00:00:00"/>',
    '  <contentHeader name="Modbus">',
    '    <coordinateInfo>',
    ...['fbd', 'ld', 'sfc'].map(scaling),
    '    </coordinateInfo>',
    '  </contentHeader>',
    '  <types>',
    '    <dataTypes/>',
    '    <pous>',
    '      <pou name="ModbusRungs" pouType="program">',
    '        <interface>',
    '          <localVars>',
    ...variables,
    '          </localVars>',
    '        </interface>',
    '        <body>',
    '          <LD>',
    ...rungs.flatMap((rung, index) => elements(rung, index * IDS, index * HEIGHT)),
    '          </LD>',
    '        </body>',
    '      </pou>',
    '    </pous>',
    '  </types>',
    '  <instances>',
    '    <configurations/>',
    '  </instances>',
    '</project>',
  ].join('\n');
}

/** Numbers of elements that a rung may have, and how high it may be. */
const IDS = 100;
const HEIGHT = 600;
const ROW = 30;
const [RAIL, CONTACT, BLOCK, COILS, END] = [20, 80, 260, 520, 680];

const variable = (name: string, type: string): string =>
  `            <variable name="${xmlText(name)}"><type>${type}</type></variable>`;

const position = (x: number, y: number): string => `<position x="${x}" y="${y}"/>`;
const from = (id: number, output?: string): string => {
  const named = output === undefined ? '' : ` formalParameter="${xmlText(output)}"`;
  return `<connectionPointIn><connection refLocalId="${id}"${named}/></connectionPointIn>`;
};

function elements(
  { block, instance, contact, inputs, passed, coils }: Rung,
  base: number,
  top: number,
): readonly string[] {
  const rail = base + 1;
  const start = base + 2;
  const called = base + 3;
  const first = base + 10;
  const end = base + 4;
  const y = (row: number) => top + ROW * (row + 1);
  const given = [
    ...inputs.map(([name, , value]) => [name, value] as const),
    ...passed.map(([name]) => [name, name] as const),
  ];
  const pin = (name: string, inside: string) => `<variable formalParameter="${xmlText(name)}">${inside}</variable>`;
  const values = given.map(
    ([, value], index) =>
      `            <inVariable localId="${first + index}" negated="false">${position(BLOCK - 120, y(index + 1))}<connectionPointOut/><expression>${xmlText(value)}</expression></inVariable>`,
  );
  const inputPins = given.slice(0, inputs.length).map(([name], index) => pin(name, from(first + index)));
  const passedPins = passed.map(([name], index) => pin(name, from(first + inputs.length + index)));
  const coilId = (index: number) => first + given.length + index;
  const drawn = coils.map(
    ([output, coil], index) =>
      `            <coil localId="${coilId(index)}" negated="false">${position(COILS, y(index))}${from(called, output)}<connectionPointOut/><variable>${xmlText(coil)}</variable></coil>`,
  );
  return [
    `            <leftPowerRail localId="${rail}">${position(RAIL, y(0))}<connectionPointOut formalParameter=""/></leftPowerRail>`,
    `            <contact localId="${start}" negated="false">${position(CONTACT, y(0))}${from(rail)}<connectionPointOut/><variable>${xmlText(contact)}</variable></contact>`,
    ...values,
    `            <block localId="${called}" typeName="${xmlText(block)}" instanceName="${xmlText(instance)}">${position(BLOCK, y(0))}`,
    `              <inputVariables>${pin('Execute', from(start))}${inputPins.join('')}</inputVariables>`,
    `              <inOutVariables>${passedPins.join('')}</inOutVariables>`,
    `              <outputVariables>${coils.map(([output]) => pin(output, '<connectionPointOut/>')).join('')}</outputVariables>`,
    '            </block>',
    ...drawn,
    `            <rightPowerRail localId="${end}">${position(END, y(0))}${coils.map((_, index) => from(coilId(index))).join('')}</rightPowerRail>`,
  ];
}
