import type { SerialLine, Transport } from '../../modbus/index.ts';
import type { Plan, ProgramNote } from '../plan.ts';
import { cString } from './c-syntax.ts';

/**
 * What a C program needs of POSIX to speak to a device, and its main. Comments stand in lines of their own, so that they can be
 * left out.
 * @module
 */

export const floatText = (own: string): string => `\
// The number whose IEEE 754 form this is.
${own}float float_of(uint32_t bits)
{
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}`;

/** How programs of C and of Arduino know a request; `result` is the type of an \`int\` that is returned. */
export const requestText = (result: string): string => `\
struct request {
    const char *name;
    // Fills the frame. Returns its length.
    int (*make)(uint8_t *frame);
    // Prints what a reply says. Returns 0 if it is good; NULL if there is no reply.
    ${result} (*show)(const uint8_t *request, const uint8_t *reply, int reply_length);
    // How many bytes the reply has, as far as they say so.
    ${result} (*wanted)(const uint8_t *reply, int reply_length);
};`;

export const REPORT = `\
static int report(const char *name, int result)
{
    if (result == 0) {
        printf("%s: good\\n", name);
    } else if (result > 0) {
        printf("%s: exception %d, %s\\n", name, result, exception_name(result));
    } else {
        printf("%s: fault %d, %s\\n", name, result, fault_name(result));
    }
    return result;
}`;

/** The speeds that have a name in termios.h. */
const BAUDS = [
  50, 75, 110, 134, 150, 200, 300, 600, 1200, 1800, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200, 230_400, 460_800,
  500_000, 576_000, 921_600, 1_000_000, 1_152_000, 1_500_000, 2_000_000, 2_500_000, 3_000_000, 3_500_000, 4_000_000,
];

const flags = ({ dataBits, parity, stopBits }: SerialLine): string =>
  [
    `CS${dataBits} | CREAD | CLOCAL`,
    ...(parity === 'none' ? [] : ['PARENB']),
    ...(parity === 'odd' ? ['PARODD'] : []),
    ...(stopBits === 2 ? ['CSTOPB'] : []),
  ].join(' | ');

/** What opens the port or the connection. A speed that POSIX has no name for is noted, and replaced by the nearest. */
export function openingText({ transport, options: { line } }: Plan, notes: ProgramNote[]): string {
  if (transport === 'tcp') return openServerText;
  const near = (baud: number) => Math.abs(Math.log(baud / line.baud));
  const baud = BAUDS.reduce((best, one) => (near(one) < near(best) ? one : best));
  if (baud !== line.baud) notes.push({ code: 'not-offered', what: 'baud', baud: line.baud, instead: baud });
  const { dataBits, parity, stopBits } = line;
  return `\
// Opens a serial port with ${baud} bits a second, ${dataBits}${parity[0]?.toUpperCase()}${stopBits}. Returns -1 if that fails.
static int open_port(const char *name)
{
    struct termios line = {0};
    int port = open(name, O_RDWR | O_NOCTTY | O_NONBLOCK);
    line.c_cflag = ${flags(line)};
    line.c_cc[VMIN] = 1;
    cfsetispeed(&line, B${baud});
    cfsetospeed(&line, B${baud});
    if (port < 0 || tcsetattr(port, TCSANOW, &line) != 0 || fcntl(port, F_SETFL, 0) != 0) {
        perror(name);
        return -1;
    }
    return port;
}`;
}

const openServerText = `\
// Connects to a server. Returns -1 if that fails.
static int open_port(const char *host)
{
    struct addrinfo hints = {0};
    struct addrinfo *list;
    int port = -1;
    hints.ai_socktype = SOCK_STREAM;
    int error = getaddrinfo(host, SERVER_PORT, &hints, &list);
    if (error != 0) {
        fprintf(stderr, "%s: %s\\n", host, gai_strerror(error));
        return -1;
    }
    for (struct addrinfo *at = list; at != NULL && port < 0; at = at->ai_next) {
        // A connection may take as long as a reply.
        struct timeval limit = {TIMEOUT_MS / 1000, TIMEOUT_MS % 1000 * 1000};
        port = socket(at->ai_family, at->ai_socktype, at->ai_protocol);
        if (port < 0) {
            continue;
        }
        setsockopt(port, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
        if (connect(port, at->ai_addr, at->ai_addrlen) != 0) {
            close(port);
            port = -1;
        }
    }
    freeaddrinfo(list);
    if (port < 0) {
        perror(host);
    }
    return port;
}`;

const SENDS = {
  tcp: `\
    if (send(port, request, (size_t)request_length, MSG_NOSIGNAL) != request_length) {
        perror("send");
        return 0;
    }`,
  serial: `\
    if (write(port, request, (size_t)request_length) != request_length || tcdrain(port) != 0) {
        perror("write");
        return 0;
    }`,
};

const echoText = `
    // The adapter gives back what is sent.
    if (receive(port, reply, request_length, deadline) < request_length) {
        return 0;
    }`;

const WAIT = `\
static void wait_ms(long long duration)
{
    struct timespec left = {duration / 1000, duration % 1000 * 1000000};
    while (nanosleep(&left, &left) != 0 && errno == EINTR) {
    }
}

`;

/** `waits`: whether anything waits for a time. */
export const exchangeText = (transport: Transport, echo: boolean, waits: boolean): string => `\
static long long now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1000LL + now.tv_nsec / 1000000;
}

${waits ? WAIT : ''}\
// Reads until so many bytes are there, or the time has come. Returns how many are there.
static int receive(int port, uint8_t *bytes, int count, long long deadline)
{
    int length = 0;
    while (length < count) {
        long long left = deadline - now_ms();
        struct pollfd incoming = {port, POLLIN, 0};
        if (poll(&incoming, 1, left > 0 ? (int)left : 0) <= 0) {
            break;
        }
        ssize_t got = read(port, bytes + length, (size_t)(count - length));
        if (got <= 0) {
            break;
        }
        length += (int)got;
    }
    return length;
}

// Sends a request and reads its reply, if there is one. Returns how many bytes the reply has.
static int exchange(int port, const struct request *kind, const uint8_t *request, int request_length, uint8_t *reply)
{
    int length = 0;
${transport === 'rtu' ? '    wait_ms(PAUSE_MS);\n' : ''}\
    // What has come too late is not for this request.
    while (receive(port, reply, FRAME_MOST, 0) > 0) {
    }
${transport === 'tcp' ? SENDS.tcp : SENDS.serial}
    if (kind->wanted == NULL) {
        return 0;
    }
    long long deadline = now_ms() + TIMEOUT_MS;${echo && transport !== 'tcp' ? echoText : ''}
    while (length < FRAME_MOST) {
        int wanted = kind->wanted(reply, length);
        if (wanted > 0 && length >= wanted) {
            break;
        }
        // Where no byte says how long the reply is, silence ends it.
        bool until_silence = wanted == 0 && length > 0;
        int count = wanted > length && wanted <= FRAME_MOST ? wanted - length : 1;
        int got = receive(port, reply + length, count, until_silence ? now_ms() + SILENCE_MS : deadline);
        length += got;
        if (got < count) {
            break;
        }
    }
    return length;
}`;

export const ASK = `\
// Sends a request and prints what its reply says. Returns whether it is good.
static bool ask_for(int port, const struct request *kind, uint8_t *reply)
{
    uint8_t request[FRAME_MOST];
    int request_length = kind->make(request);
    int reply_length = exchange(port, kind, request, request_length, reply);
    if (kind->show == NULL) {
        printf("%s: sent\\n", kind->name);
        return true;
    }
    return kind->show(request, reply, reply_length) == 0;
}

static bool ask(int port, const struct request *kind)
{
    uint8_t reply[FRAME_MOST];
    return ask_for(port, kind, reply);
}`;

/** A condition that is read again and again. A reading that fails is repeated. */
export const UNTIL = `\
// Reads again and again until a condition holds. Returns whether that was in time.
static bool ask_until(
        int port, const struct request *kind, bool (*holds)(const uint8_t *reply), int interval, int limit)
{
    uint8_t reply[FRAME_MOST];
    long long end = now_ms() + limit;
    for (;;) {
        long long next = now_ms() + interval;
        if (ask_for(port, kind, reply) && holds(reply)) {
            return true;
        }
        long long now = now_ms();
        long long rest = next > now ? next - now : 0;
        if (now + rest >= end) {
            printf("%s: the condition did not hold in time\\n", kind->name);
            return false;
        }
        wait_ms(rest);
    }
}`;

export const mainText = ({ transport, options: { line, server }, requests, sequence }: Plan): string => {
  const several = requests.length > 1;
  return `\
static void print_bytes(const struct request *kind)
{
    uint8_t frame[FRAME_MOST];
    int length = kind->make(frame);
    for (int i = 0; i < length; i++) {
        printf(i < length - 1 ? "%02X " : "%02X\\n", frame[i]);
    }
}

// Checks a reply that is given in hexadecimal. Returns whether it is good.
static bool check_text(const struct request *kind, const char *text)
{
    uint8_t request[FRAME_MOST];
    uint8_t reply[FRAME_MOST] = {0};
    unsigned value;
    int length = 0;
    for (int used = 0; length < FRAME_MOST && sscanf(text, " %2x%n", &value, &used) == 1; text += used) {
        reply[length++] = (uint8_t)value;
    }
    kind->make(request);
    return kind->show == NULL || kind->show(request, reply, length) == 0;
}

int main(int argc, char **argv)
{
    const int count = sizeof requests / sizeof requests[0];
    if (argc > 1 && strcmp(argv[1], "--bytes") == 0) {
        for (int i = 0; i < count; i++) {
            print_bytes(requests[i]);
        }
        return 0;
    }
    if (argc > 2 && strcmp(argv[1], "--check") == 0) {
${
  several
    ? `\
        int number = argc > 3 ? atoi(argv[3]) : 1;
        return number >= 1 && number <= count && check_text(requests[number - 1], argv[2]) ? 0 : 1;`
    : `\
        return check_text(requests[0], argv[2]) ? 0 : 1;`
}
    }
    int port = open_port(argc > 1 ? argv[1] : ${cString(transport === 'tcp' ? server.host : line.port)});
    if (port < 0) {
        return 1;
    }
${
  sequence === undefined
    ? `\
    bool good = true;
    for (int i = 0; i < count; i++) {
        good = ask(port, requests[i]) && good;
    }`
    : `\
    bool good = run_steps(port);
    run_finally(port);`
}
    close(port);
    return good ? 0 : 1;
}`;
};
