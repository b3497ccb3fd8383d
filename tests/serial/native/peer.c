/* The other end of the cable, spoken by libmodbus.
 *
 * peer serve TTY UNIT
 *   A server of 100 coils (every third on), 100 discrete inputs (every second on), 200 holding registers (register i
 *   is 1000 + i) and 100 input registers (2000 + i). Prints "ready".
 * peer read TTY UNIT ADDRESS QUANTITY
 *   A client: reads holding registers once and prints them, or what went wrong.
 * peer rate TTY UNIT QUANTITY SECONDS
 *   A client: reads holding registers from 0 as fast as it can, and prints how many times a second. */
#include <errno.h>
#include <modbus.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static modbus_t *open_line(const char *tty, int unit) {
  modbus_t *line = modbus_new_rtu(tty, 9600, 'E', 8, 1);
  if (!line || modbus_set_slave(line, unit) || modbus_connect(line)) { perror(tty); exit(1); }
  /* Half a second is too little on a machine with other work to do. */
  modbus_set_byte_timeout(line, 5, 0);
  return line;
}

static int serve(const char *tty, int unit) {
  modbus_t *line = open_line(tty, unit);
  modbus_mapping_t *map = modbus_mapping_new(100, 100, 200, 100);
  if (!map) return 1;
  for (int i = 0; i < 100; i++) map->tab_bits[i] = i % 3 == 0;
  for (int i = 0; i < 100; i++) map->tab_input_bits[i] = i % 2 == 0;
  for (int i = 0; i < 200; i++) map->tab_registers[i] = 1000 + i;
  for (int i = 0; i < 100; i++) map->tab_input_registers[i] = 2000 + i;
  /* Behind a request to another unit libmodbus ignores one message, or this long. */
  modbus_set_response_timeout(line, 0, 100000);
  puts("ready");
  fflush(stdout);
  for (;;) {
    uint8_t query[MODBUS_RTU_MAX_ADU_LENGTH];
    int n = modbus_receive(line, query);
    if (n > 0) modbus_reply(line, query, n, map);
    else if (n == -1 && (errno == EIO || errno == EBADF || errno == ECONNRESET)) return 2;
    /* A frame that is cut or whose CRC is wrong is answered by silence. */
  }
}

static int read_once(const char *tty, int unit, int address, int quantity) {
  modbus_t *line = open_line(tty, unit);
  modbus_set_response_timeout(line, 20, 0);
  uint16_t values[125];
  if (quantity > 125 || modbus_read_registers(line, address, quantity, values) != quantity) {
    puts(modbus_strerror(errno));
    return 1;
  }
  for (int i = 0; i < quantity; i++) printf("%d%c", values[i], i + 1 < quantity ? ' ' : '\n');
  return 0;
}

static int rate(const char *tty, int unit, int quantity, double seconds) {
  modbus_t *line = open_line(tty, unit);
  uint16_t values[125];
  struct timespec begin, now;
  long done = 0;
  double passed;
  clock_gettime(CLOCK_MONOTONIC, &begin);
  do {
    if (quantity > 125 || modbus_read_registers(line, 0, quantity, values) != quantity) {
      puts(modbus_strerror(errno));
      return 1;
    }
    done++;
    clock_gettime(CLOCK_MONOTONIC, &now);
    passed = now.tv_sec - begin.tv_sec + (now.tv_nsec - begin.tv_nsec) / 1e9;
  } while (passed < seconds);
  printf("%.0f\n", done / passed);
  return 0;
}

int main(int argc, char **argv) {
  if (argc == 4 && !strcmp(argv[1], "serve")) return serve(argv[2], atoi(argv[3]));
  if (argc == 6 && !strcmp(argv[1], "read")) return read_once(argv[2], atoi(argv[3]), atoi(argv[4]), atoi(argv[5]));
  if (argc == 6 && !strcmp(argv[1], "rate")) return rate(argv[2], atoi(argv[3]), atoi(argv[4]), atof(argv[5]));
  fputs("usage: peer serve TTY UNIT | read TTY UNIT ADDRESS QUANTITY | rate TTY UNIT QUANTITY SECONDS\n", stderr);
  return 64;
}
