import type { Transport } from '../../modbus/index.ts';

/**
 * What an Arduino needs to speak to a device. Comments stand in lines of their own, so that they can be left out.
 * @module
 */

export const FLOAT = `\
// The number whose IEEE 754 form this is.
static float float_of(uint32_t bits)
{
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}`;

export const REPORT = `\
static long report(const char *name, long result)
{
    Serial.print(name);
    if (result == 0) {
        Serial.println(F(": good"));
        return 0;
    }
    Serial.print(result > 0 ? F(": exception ") : F(": fault "));
    Serial.print(result);
    Serial.print(F(", "));
    Serial.println(result > 0 ? exception_name(result) : fault_name(result));
    return result;
}`;

const SEND = {
  serial: `\
    digitalWrite(DIRECTION_PIN, HIGH);
    MODBUS.write(request, request_length);
    // Waits until the last bit is sent.
    MODBUS.flush();
    digitalWrite(DIRECTION_PIN, LOW);`,
  tcp: `\
    if (!client.connected() && !client.connect(SERVER, SERVER_PORT)) {
        return 0;
    }
    client.write(request, request_length);`,
};

export const exchangeText = (transport: Transport, echo: boolean): string => {
  const skips = echo && transport !== 'tcp';
  return `\
// Sends a request and reads its reply, if there is one. Returns how many bytes the reply has.
static int exchange(const struct request *kind, const uint8_t *request, int request_length, uint8_t *reply)
{
    int length = 0;
${skips ? '    // The adapter gives back what is sent.\n    int echoed = request_length;\n' : ''}\
${transport === 'rtu' ? '    delay(SILENCE_MS);\n' : ''}\
    // What has come too late is not for this request.
    while (MODBUS.available() > 0) {
        MODBUS.read();
    }
${transport === 'tcp' ? SEND.tcp : SEND.serial}
    if (kind->wanted == NULL) {
        return 0;
    }
    unsigned long sent = millis();
    unsigned long last = sent;
    while (length < FRAME_MOST && millis() - sent < TIMEOUT_MS) {
        int wanted = kind->wanted(reply, length);
        if (wanted > 0 && length >= wanted) {
            break;
        }
        // Where no byte says how long the reply is, silence ends it.
        if (wanted == 0 && length > 0 && millis() - last > SILENCE_MS) {
            break;
        }
        if (MODBUS.available() > 0) {
            uint8_t next = MODBUS.read();
            last = millis();
${
  skips
    ? `\
            if (echoed > 0) {
                echoed--;
            } else {
                reply[length++] = next;
            }`
    : `\
            reply[length++] = next;`
}
        }
    }
    return length;
}`;
};

export const ASK = `\
// Sends a request and prints what its reply says. Returns whether it is good.
static bool ask_for(const struct request *kind, uint8_t *reply)
{
    uint8_t request[FRAME_MOST];
    int request_length = kind->make(request);
    int reply_length = exchange(kind, request, request_length, reply);
    if (kind->show == NULL) {
        Serial.print(kind->name);
        Serial.println(F(": sent"));
        return true;
    }
    return kind->show(request, reply, reply_length) == 0;
}

static bool ask(const struct request *kind)
{
    uint8_t reply[FRAME_MOST];
    return ask_for(kind, reply);
}`;

export const UNTIL = `\
// Reads again and again until a condition holds. Returns whether that was in time.
static bool ask_until(const struct request *kind, bool (*holds)(const uint8_t *reply),
        unsigned long interval, unsigned long limit)
{
    uint8_t reply[FRAME_MOST];
    unsigned long start = millis();
    for (;;) {
        unsigned long asked = millis();
        if (ask_for(kind, reply) && holds(reply)) {
            return true;
        }
        unsigned long taken = millis() - asked;
        unsigned long rest = taken < interval ? interval - taken : 0;
        if (millis() - start + rest >= limit) {
            Serial.print(kind->name);
            Serial.println(F(": the condition did not hold in time"));
            return false;
        }
        delay(rest);
    }
}`;

export const setupText = (transport: Transport, baud: number, format: string, isSequence: boolean): string => `\
void setup()
{
    // What is said to the PC.
    Serial.begin(115200);
${
  transport === 'tcp'
    ? `\
    Ethernet.begin(mac);`
    : `\
    pinMode(DIRECTION_PIN, OUTPUT);
    digitalWrite(DIRECTION_PIN, LOW);
    MODBUS.begin(${baud}, ${format});`
}${
  isSequence
    ? `
    run_steps();
    run_finally();`
    : ''
}
}`;

export const ONCE = `\
void loop()
{
    for (unsigned i = 0; i < sizeof requests / sizeof requests[0]; i++) {
        ask(requests[i]);
    }
    delay(1000);
}`;
