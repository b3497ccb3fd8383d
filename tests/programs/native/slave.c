/* slave HOST PORT UNIT: a server by libmodbus, on a pseudo-terminal (RTU) and at HOST:PORT (TCP), until standard input ends.
 *
 * Prints the path of the pseudo-terminal. It holds 100 coils (every third on), 100 discrete inputs (every second on), 200 holding
 * registers (register i is 1000 + i) and 100 input registers (2000 + i), one set for both. It answers one unit only; libmodbus
 * itself would answer every unit by TCP. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <modbus.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

enum { INPUT, TERMINAL, LISTENER, CONNECTIONS, ALL = CONNECTIONS + 8 };

static modbus_mapping_t *map;
static int own_unit;

/* Behind a request to another unit, libmodbus ignores one message by RTU, or so many microseconds. */
static const int IGNORED = 20000;

static void fail(const char *what)
{
    perror(what);
    exit(1);
}

/* A pseudo-terminal as it comes from a serial port: raw, and never hung up, as this end holds it open. */
static int open_terminal(void)
{
    int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    if (terminal < 0 || grantpt(terminal) || unlockpt(terminal)) fail("pseudo-terminal");
    int other = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    struct termios settings;
    if (other < 0 || tcgetattr(other, &settings)) fail(ptsname(terminal));
    cfmakeraw(&settings);
    if (tcsetattr(other, TCSANOW, &settings)) fail(ptsname(terminal));
    puts(ptsname(terminal));
    return terminal;
}

/* Answers what has come; 0 when there is nothing more to come. */
static int answer(modbus_t *line, int is_serial)
{
    uint8_t query[MODBUS_MAX_ADU_LENGTH];
    int length = modbus_receive(line, query);
    if (is_serial) {
        if (length > 0) modbus_reply(line, query, length, map);
        else if (length == 0) modbus_receive(line, query);
        return 1;
    }
    if (length > 0 && query[6] == own_unit) modbus_reply(line, query, length, map);
    return length >= 0;
}

int main(int argc, char **argv)
{
    if (argc != 4) return 64;
    own_unit = atoi(argv[3]);
    modbus_t *serial = modbus_new_rtu("/dev/null", 19200, 'N', 8, 1);
    modbus_t *tcp = modbus_new_tcp(argv[1], atoi(argv[2]));
    map = modbus_mapping_new(100, 100, 200, 100);
    if (!serial || !tcp || !map) fail("libmodbus");
    for (int i = 0; i < 100; i++) map->tab_bits[i] = i % 3 == 0;
    for (int i = 0; i < 100; i++) map->tab_input_bits[i] = i % 2 == 0;
    for (int i = 0; i < 200; i++) map->tab_registers[i] = 1000 + i;
    for (int i = 0; i < 100; i++) map->tab_input_registers[i] = 2000 + i;
    struct pollfd files[ALL] = {{STDIN_FILENO, POLLIN, 0}, {open_terminal(), POLLIN, 0}, {modbus_tcp_listen(tcp, 8), POLLIN, 0}};
    if (files[LISTENER].fd < 0) fail(argv[1]);
    for (int i = CONNECTIONS; i < ALL; i++) files[i] = (struct pollfd){-1, POLLIN, 0};
    if (modbus_set_slave(serial, own_unit) || modbus_set_socket(serial, files[TERMINAL].fd)) fail("libmodbus");
    modbus_set_response_timeout(serial, 0, IGNORED);
    fflush(stdout);
    for (;;) {
        if (poll(files, ALL, -1) < 0 && errno != EINTR) fail("poll");
        char unread[64];
        if (files[INPUT].revents && read(STDIN_FILENO, unread, sizeof unread) <= 0) return 0;
        if (files[TERMINAL].revents) answer(serial, 1);
        for (int i = CONNECTIONS; i < ALL; i++) {
            if (!files[i].revents) continue;
            modbus_set_socket(tcp, files[i].fd);
            if (answer(tcp, 0)) continue;
            close(files[i].fd);
            files[i].fd = -1;
        }
        if (files[LISTENER].revents) {
            int listener = files[LISTENER].fd, i = CONNECTIONS;
            while (i < ALL - 1 && files[i].fd >= 0) i++;
            if (files[i].fd >= 0) close(files[i].fd);
            files[i].fd = modbus_tcp_accept(tcp, &listener);
        }
    }
}
