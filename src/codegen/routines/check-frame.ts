import { binary, type Expression, type Name, type Statement } from '../code.ts';
import { asciiCharacters, type Envelope } from './envelope.ts';
import { fail, refuse } from './refuse.ts';
import { array, byte, call, declare, element, giveBack, int, loop, name, plus, toInt, when, wordOf } from './terms.ts';

const EXCEPTION = 0x80;
/** Transaction and protocol of a TCP header. */
const REPEATED = 4;
const length = name('int', 'reply length');
const index = name('int', 'index');

/** How many bytes the reply stands for. */
export const bytesIn = ({ transport }: Envelope): Expression => (transport === 'ascii' ? name('int', 'bytes') : length);

/** That a reply is one frame, right by its checksum, from the unit and to the function that was asked; or its exception. */
export const frameChecked = (envelope: Envelope, wanted: Name): readonly Statement[] => [
  refuse(length, '=', int(0), 'no reply'),
  ...whole[envelope.transport](envelope, wanted),
  ...answers(envelope),
];

const tooShort = ({ least }: Envelope): Statement => refuse(length, '<', int(least), 'too short');

/** That the reply has the length that its bytes say. */
function asLong(wanted: Name): readonly Statement[] {
  const told = name('int', 'wanted');
  const isLonger = binary(binary(told, '>', int(0)), 'and', binary(length, '>', told));
  return [
    declare('wanted', call('int', wanted, array('reply'), length), false),
    refuse(length, '<', told, 'too short'),
    when(isLonger, fail('too long')),
  ];
}

const whole: Readonly<Record<Envelope['transport'], (envelope: Envelope, wanted: Name) => readonly Statement[]>> = {
  rtu: (envelope, wanted) => {
    const [answered, asked] = codes(envelope);
    const same = binary(binary(answered, '&', byte(EXCEPTION - 1)), '=', asked);
    const end = plus(length, int(-envelope.tail));
    const sent = wordOf(element('byte', 'reply', plus(length, int(-1))), element('byte', 'reply', end));
    return [
      tooShort(envelope),
      when(same, asLong(wanted), [], { comment: 'the length of a reply to this function', spans: ['functionCode'] }),
      refuse(call('word', 'crc', array('reply'), end), '≠', sent, 'wrong checksum', {
        spans: ['checksum'],
        comment: 'CRC, low byte first',
      }),
    ];
  },
  ascii: (envelope) => {
    const { colon, cr, lf } = asciiCharacters;
    const fromEnd = (back: number) => element('byte', 'reply', binary(length, '-', int(back)));
    const digits = binary(length, '-', int(2));
    return [
      refuse(element('byte', 'reply', int(0)), '≠', byte(colon), 'wrong characters', { spans: ['start'] }),
      refuse(fromEnd(1), '≠', byte(lf), 'too short', { spans: ['end'] }),
      tooShort(envelope),
      refuse(fromEnd(2), '≠', byte(cr), 'wrong characters', { spans: ['end'] }),
      refuse(binary(length, '%', int(2)), '=', int(0), 'wrong characters'),
      loop('index', int(1), digits, [
        refuse(call('int', 'digit value', element('byte', 'reply', index)), '<', int(0), 'wrong characters'),
      ]),
      declare('bytes', envelope.bytesIn(length), false),
      refuse(
        call('byte', 'lrc', array('reply'), plus(length, int(-4))),
        '≠',
        envelope.byteAt('reply', plus(bytesIn(envelope), int(-envelope.tail))),
        'wrong checksum',
        { spans: ['checksum'] },
      ),
    ];
  },
  tcp: (envelope, wanted) => {
    const differs = refuse(
      element('byte', 'reply', index),
      '≠',
      element('byte', 'request', index),
      'other transaction',
    );
    return [
      tooShort(envelope),
      ...asLong(wanted),
      loop('index', int(0), int(REPEATED), [differs], {
        spans: ['transactionId', 'protocolId'],
        comment: 'transaction and protocol',
      }),
    ];
  },
  pdu: (envelope) => [tooShort(envelope)],
};

/** The function codes of the reply and of the request. */
const codes = ({ code, byteAt }: Envelope): readonly [Expression, Expression] => [
  byteAt('reply', int(code)),
  byteAt('request', int(code)),
];

function answers(envelope: Envelope): readonly Statement[] {
  const { transport, code, tail, byteAt } = envelope;
  const unit = int(code - 1);
  const [answered, asked] = codes(envelope);
  const bytes = bytesIn(envelope);
  const end = int(code + 2 + tail);
  const exception = byteAt('reply', int(code + 1));
  const exact = [refuse(bytes, '<', end, 'too short'), refuse(bytes, '>', end, 'too long')];
  return [
    refuse(byteAt('reply', unit), '≠', byteAt('request', unit), 'other unit', { spans: ['unitId'], comment: 'unit' }),
    when(
      binary(answered, '=', binary(asked, '|', byte(EXCEPTION))),
      [
        // The length of an exception of RTU has been looked at.
        ...(transport === 'rtu' ? [] : exact),
        refuse(exception, '=', byte(0), 'other function'),
        giveBack(toInt(exception), { spans: ['exceptionCode'] }),
      ],
      [],
      { comment: 'an exception', spans: ['functionCode'] },
    ),
    refuse(answered, '≠', asked, 'other function', { spans: ['functionCode'], comment: 'function' }),
  ];
}
