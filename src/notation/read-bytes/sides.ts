import type { ChunkLabel } from './types.ts';

/** What one word of a log says of the bytes beside it. `role` names who speaks, which any other word of the kind overrules. */
export interface ChunkWord extends Omit<ChunkLabel, 'time'> {
  readonly role?: true;
  /** An arrow; `prompt` for `->`, which behind a time tells a direction only beside arrows that point the other way. */
  readonly arrow?: 'arrow' | 'prompt';
}

const words = (label: ChunkWord, list: string) => list.split(/\s+/).map((word) => [word, label] as const);

const TX = { direction: 'tx' } as const;
const RX = { direction: 'rx' } as const;
const REQUEST = { direction: 'request' } as const;
const RESPONSE = { direction: 'response' } as const;

/** Words that say a side wherever they stand, in English, German, Spanish, French, Portuguese, Italian, Dutch and Russian. */
const ANYWHERE: ReadonlyMap<string, ChunkWord> = new Map([
  ...words(
    TX,
    'tx txd send sent sends sending transmit transmits transmitted transmitting written writing outgoing irp_mj_write',
  ),
  ...words(
    RX,
    'rx rxd recv recvd recd rcvd rcv receive received receives receiving recieved recieve incoming irp_mj_read',
  ),
  ...words(REQUEST, 'request requests requested req query queries indication command_sent'),
  ...words(
    RESPONSE,
    'response responses responds responded respond resp rsp reply replies replied answer answers answered',
  ),
  ...words(TX, 'gesendet senden sendet sende geschrieben übertragen'),
  ...words(RX, 'empfangen empfangs empfängt empfange gelesen'),
  ...words(REQUEST, 'anfrage abfrage anforderung'),
  ...words(RESPONSE, 'antwort antwortet antworten'),
  ...words(TX, 'enviado enviada enviando enviar envía envia envio envío transmitido escrito inviato inviata invio'),
  ...words(
    RX,
    'recibido recibida recibiendo recibir recibe leído recebido recebida recebendo ricevuto ricevuta ricezione',
  ),
  ...words(REQUEST, 'petición peticion solicitud consulta pregunta requisição requisicao pedido richiesta'),
  ...words(RESPONSE, 'respuesta responde resposta risposta'),
  ...words(
    TX,
    'envoyé envoyée envoyer envoie envoi émis émise émission emission transmis verzonden verstuurd отправлено передано',
  ),
  ...words(RX, 'reçu reçue recu réception reception reçoit ontvangen получено принято'),
  ...words(REQUEST, 'requête requete demande verzoek запрос'),
  ...words(RESPONSE, 'réponse reponse répond repond antwoord ответ'),
  ...words(RX, 'erhalten erhalte erhielt bekommen bekomme bekam'),
  ...words(TX, 'trasmesso trasmessa trasmissione wysłano wysłane wysyłam wysyłanie nadano odesláno odeslané odesílám'),
  ...words(RX, 'odebrano odebrane otrzymano odbiór přijato přijaté přijímám mottaget modtaget mottatt vastaanotettu'),
  ...words(TX, 'skickat skickar sendt lähetetty gönderilen gönderildi gönder küldött надіслано отправка передача'),
  ...words(RX, 'alınan alındı fogadott отримано получен принят приём прием'),
  ...words(REQUEST, 'zapytanie żądanie dotaz požadavek förfrågan forespørsel pyyntö istek sorgu kérés запит'),
  ...words(RESPONSE, 'odpowiedź odpověď svar vastaus yanıt cevap válasz відповідь'),
  ...words({ transport: 'rtu' }, 'rtu'),
  ...words({ transport: 'tcp' }, 'tcp mbap'),
  ...words({ transport: 'ascii' }, 'ascii'),
]);

/** The same in Chinese, Japanese and Korean, where words are not parted: the first of these in a row of characters counts. */
const CHINESE: readonly (readonly [string, ChunkWord])[] = [
  ...words(TX, '发送 發送 下发 发出 写入 送信 송신 전송 보냄'),
  ...words(RX, '接收 收到 接受 上报 读取到 受信 수신 받음'),
  ...words(REQUEST, '请求 請求 询问 查询 要求 요청'),
  ...words(RESPONSE, '响应 響應 应答 應答 回复 回覆 回应 回應 返回 応答 응답'),
];
const CHINESE_ALONE: ReadonlyMap<string, ChunkWord> = new Map([
  ...words(TX, '发 發 送'),
  ...words(RX, '收'),
  ...words({ ...REQUEST, role: true }, '主站 主机 主機 客户端'),
  ...words({ ...RESPONSE, role: true }, '从站 从机 從站 從機 服务器'),
]);

/** Words with other meanings too, which count only as a label. */
const AS_LABEL: ReadonlyMap<string, ChunkWord> = new Map([
  ...words(
    TX,
    'write out output t w snd sw down sendto ausgang schreiben sendung salida transmisión transmissão sortie',
  ),
  ...words(RX, 'read in input r got up readfn recvfrom eingang lesen empfang entrada recepción recepção entrée'),
  ...words(
    TX,
    'küldés trimis αποστολή gửi изпратено poslano odoslané odeslání nadawanie посылка saadetud išsiųsta enviat',
  ),
  ...words(RX, 'fogadás primit λήψη nhận prejeto primljeno prijaté příjem прием gauta rebut terima mottar vastaanotto'),
  ...words(TX, 'kirim ارسال إرسال נשלח ส่ง послато sender lähetys sänder'),
  ...words(RX, 'دریافت استقبال התקבל รับ примљено'),
  ...words(REQUEST, 'poll q ask question vraag frage'),
  ...words(RESPONSE, 'res confirmation ack'),
  ...words({ ...REQUEST, role: true }, 'master client host plc scada hmi maestro maître maitre'),
  ...words({ ...RESPONSE, role: true }, 'slave server device drive inverter meter esclavo esclave'),
]);

/** Words that say a side only right before a row of bytes: `I wrote 01 03 00 00 …`. */
const BEFORE_ROW: ReadonlyMap<string, ChunkWord> = new Map([
  ...words(TX, 'writes wrote'),
  ...words(RX, 'reads got gets'),
  ...words({ ...REQUEST, role: true }, 'command cmd pc'),
]);
/** Fewest bytes that are such a row: more than a checksum has. */
const ROW = /^ {0,4}:?\s{1,4}(?:b['"]|['"]?(?:0x|\\x)?[0-9a-f]{1,2}(?:[\s,:.-]{0,2}(?:0x|\\x)?[0-9a-f]{1,2}){3})/i;
/** What makes no side of such a word: `expected C5 CD got C0 F1`. */
export const COMPARED = /expect|should|instead/i;
const BEFORE = 60;

/** What follows a word that is a label: a colon, a bracket, or the name of what was read or written. */
const BEHIND = /^(?: {0,4}[:|]|[>\]]|\[\d{1,4}\] ?:| (?:data|bytes|buffer|frame|packet|message|telegram)\b)/i;
/** What makes a statement of a word rather than a label: `should be sent`. */
const PASSIVE = /(?:^|\s)(?:be|is|was|are|were|been|not) $/i;
/** Words that are labels in capitals at the beginning of a line, right before bytes. */
const CAPITAL = /^(?:IN|OUT|READ|WRITE)$/;
const BYTES = /^\s{1,4}(?:0x)?[0-9a-f]{2}[\s,]/i;
const TO = /^ (?:to|into)\b/i;
/** What may stand before a call, as a tracer prints it: the number of the process, and the time. */
const TRACED = /^(?:\[pid +\d+\] +|\d+ +)?(?:[\d:.]+ +)?$/;
const CALL = /^(?:read|write|sendto|recvfrom)$/;
/** A word that is the value of a field for the side: `"dir": "in"`. */
const VALUE = /(?:^|[^a-z])(?:dir|direction|type|side|kind|event|op|action)["']?\s{0,2}[:=]\s{0,2}["']?$/i;
const CELL = /[,;\t|]/;
/** The second half of the name of a variable that holds bytes, as in `rx_buf` and `sendData`. */
const HOLDS = /^(.+?)_?(?:data|buf|buff|buffer|frame|packet|msg|message|bytes|array|telegramm?|cmd)$/i;
/** The same with the name of what is used to send before it, or with a number: `PORT_SEND`, `request_1`. */
const NAMED = /^(?:(?:port|uart|serial|modbus|rtu|tcp|bus)_)?([a-z]{2,12})_?\d{0,4}$/i;
const NAME = /^ ?[:=[\]>]/;

/** What a word says that stands at `[from, to)` of the line, if anything. */
export function chunkWord(word: string, line: string, from: number, to: number): ChunkWord | undefined {
  const lower = word.toLowerCase().normalize();
  const known = ANYWHERE.get(lower);
  if (known !== undefined) return PASSIVE.test(line.slice(Math.max(0, from - 8), from)) ? undefined : known;
  if (lower.charCodeAt(0) > 0x2e7f) return chineseWord(word);
  const label = AS_LABEL.get(lower);
  // The part of a program that prints the line, `mb_object.master:`, does not speak.
  const isTag = label?.role === true && /[._]/.test(line[from - 1] ?? '');
  if (label !== undefined && !isTag && isLabel(lower, line, from, to)) {
    return label.role === true && TO_WHOM.test(line.slice(Math.max(0, from - 8), from)) ? turned(label) : label;
  }
  const row = BEFORE_ROW.get(lower);
  if (row !== undefined && ROW.test(line.slice(to, to + 24))) {
    if (!COMPARED.test(line.slice(Math.max(0, from - BEFORE), from))) return row;
  }
  const holder = word.length > 5 ? HOLDS.exec(word)?.[1] : undefined;
  const name = holder ?? (NAME.test(line.slice(to, to + 2)) ? NAMED.exec(word)?.[1] : undefined);
  return name === undefined ? undefined : ANYWHERE.get(name.toLowerCase());
}

/** What is said to a slave is a request. */
const TO_WHOM = /\b(?:to|an|zum|aan|al|vers) (?:the )?$/i;
const turned = (word: ChunkWord): ChunkWord =>
  word.direction === 'request' ? { ...RESPONSE, role: true } : { ...REQUEST, role: true };

/** The direction of what somebody sends to somebody else: `master -> slave`. */
export const partyOf = (word: string): ChunkWord['direction'] => {
  const label = AS_LABEL.get(word);
  return label?.role === true ? label.direction : undefined;
};

function isLabel(word: string, line: string, from: number, to: number): boolean {
  const behind = line.slice(to, to + 12);
  if (CAPITAL.test(line.slice(from, to)) && line.slice(0, from).trim() === '' && BYTES.test(behind)) return true;
  if (BEHIND.test(behind) || (word === 'write' && TO.test(behind))) return true;
  // A call that begins its line, as a tracer prints it: `read(3, "…")`.
  if (behind[0] === '(') return CALL.test(word) && TRACED.test(line.slice(0, from).trimStart());
  if (behind[0] === ')' && line[from - 1] === '(') return true;
  if (VALUE.test(line.slice(Math.max(0, from - BEFORE), from))) return true;
  return from > 0 && CELL.test(line[from - 1] ?? '') && line[to] === line[from - 1];
}

function chineseWord(word: string): ChunkWord | undefined {
  const alone = CHINESE_ALONE.get(word);
  if (alone !== undefined) return alone;
  let best: ChunkWord | undefined;
  let first = word.length;
  for (const [part, says] of CHINESE) {
    const at = word.indexOf(part);
    if (at >= 0 && at < first) {
      best = says;
      first = at;
    }
  }
  return best;
}

const ARROW =
  /(?:<{2,3}(?=[\s:]|$)|>{2,3}(?=[\s:]|$)|<[-=]{1,20}(?![-=>])|(?<![<=-])[-=]{1,20}>|[\u2190\u2192\u21d0\u21d2\u21e6\u21e8\u25b6\u25ba\u25c0\u25c4\u27f5\u27f6\u2b05\u2794\u27a1])/y;
const RIGHT = /[>\u2192\u21d2\u21e8\u25b6\u25ba\u27f6\u2794\u27a1]/;

const USB =
  /^[0-9a-f]{8,16} \d{1,10} [SCE] [BI]([io]):\d{1,3}:\d{3}:\d{1,2} -?\d{1,4}(?::\d{1,6}){0,2} \d{1,6}(?= [<=>])/;

/** What the monitor of USB of Linux says before the bytes of a transfer, to or from an adapter, and where that ends. */
export function usbTransfer(line: string): { readonly word: ChunkWord; readonly end: number } | undefined {
  const found = USB.exec(line);
  return found === null ? undefined : { word: { direction: found[1] === 'o' ? 'tx' : 'rx' }, end: found[0].length };
}

/** The arrow that stands at a place of a line: `>>>`, `<--`, `=>`; right is sent, left is received. */
export function arrowAt(line: string, at: number): { readonly word: ChunkWord; readonly end: number } | undefined {
  ARROW.lastIndex = at;
  const arrow = ARROW.exec(line)?.[0];
  if (arrow === undefined) return undefined;
  return {
    word: { direction: RIGHT.test(arrow) ? 'tx' : 'rx', arrow: arrow === '->' ? 'prompt' : 'arrow' },
    end: at + arrow.length,
  };
}
