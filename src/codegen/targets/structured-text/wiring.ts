import type { Plan } from '../../plan.ts';

/** How a program is used in the systems that take it. */
export function wiring({ options: { part }, transport, requests }: Plan): readonly string[] {
  const use = [
    'CODESYS, TwinCAT: each TYPE, FUNCTION and FUNCTION_BLOCK is an object of its own. OpenPLC: take the file as it is.',
  ];
  if (part !== 'exchange') return use;
  const answered = requests.some(({ check }) => check !== undefined);
  return [
    ...use,
    'The block knows no port. In each cycle, with an instance of it called Mb:',
    ...(answered ? ['1. append the bytes that have come in to RxBuffer[RxCount], and count them in RxCount;'] : []),
    `${answered ? 2 : 1}. call Mb(Execute := ..., ${answered ? 'RxBuffer := RxBuffer, RxCount := RxCount' : ''});`.replace(
      ', )',
      ')',
    ),
    `${answered ? 3 : 2}. if Mb.TxStart is TRUE, send Mb.TxBuffer[0] to Mb.TxBuffer[Mb.TxCount - 1].`,
    ...ports(transport),
  ];
}

const ports = (transport: Plan['transport']): readonly string[] =>
  transport === 'tcp'
    ? [
        'CODESYS: NBS.TCP_Read and NBS.TCP_Write of Net Base Services. TwinCAT: FB_SocketReceive and FB_SocketSend of Tc2_TcpIp.',
        'OpenPLC has no sockets in Structured Text: a C block passes the bytes.',
      ]
    : [
        'CODESYS: COM.Read and COM.Write of CAA SerialCom. TwinCAT: ReceiveByte and SendData of Tc2_SerialCom.',
        'OpenPLC has no serial port in Structured Text: a C block passes the bytes.',
      ];
