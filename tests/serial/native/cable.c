/* A serial cable between a browser and a device, made of two pseudo-terminals, and hot plug events.
 *
 * cable join PAGE_LINK DEVICE_LINK [echo] [pace] [lump=MILLISECONDS]
 *   Two pseudo-terminals joined like a null-modem cable, reached through two symbolic links. Prints "ready", then a
 *   line "BAUD PARITY STOPBITS FLOW" whenever the page's end is set up anew. Killing it is pulling it out.
 *   echo: the page hears its own bytes, as on some RS-485 adapters.
 *   pace: each character takes the time it has at the page's speed and format, half duplex.
 *   lump: what the device sends reaches the page in lumps so far apart, as from a USB adapter.
 * cable uevent KEY=VALUE...
 *   Multicasts one event to this network namespace, as udevd does when an adapter is plugged in or pulled out. */
#define _GNU_SOURCE
#include <arpa/inet.h>
#include <asm/termbits.h>
#include <fcntl.h>
#include <linux/netlink.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#define PAGE 0
#define DEVICE 1
/* The device's settings are looked at this often when nothing comes. */
#define LOOK_NS 5000000LL

static void die(const char *what) { perror(what); exit(1); }

static int64_t now_ns(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec * 1000000000LL + t.tv_nsec;
}

/* One end of the cable: the master side of a pseudo-terminal, its slave side reached through a link. */
static int make_end(const char *link, int *slave) {
  int master = open("/dev/ptmx", O_RDWR | O_NOCTTY), unlocked = 0, number;
  if (master < 0 || ioctl(master, TIOCSPTLCK, &unlocked) < 0 || ioctl(master, TIOCGPTN, &number) < 0) die("/dev/ptmx");
  char path[32];
  snprintf(path, sizeof path, "/dev/pts/%d", number);
  struct termios2 raw;
  /* Kept open, so that the end stays there while nobody has opened it. */
  if ((*slave = open(path, O_RDWR | O_NOCTTY)) < 0 || ioctl(*slave, TCGETS2, &raw) < 0) die(path);
  raw.c_iflag = raw.c_oflag = raw.c_lflag = 0;
  if (ioctl(*slave, TCSETS2, &raw) < 0) die("TCSETS2");
  unlink(link);
  if (symlink(path, link) < 0) die(link);
  return master;
}

/* Bytes on their way, each with the time at which it has arrived. */
struct lane { uint8_t byte[65536]; int64_t at[65536]; unsigned from, to; };
static struct lane lanes[2];

static void push(struct lane *lane, uint8_t byte, int64_t at) {
  unsigned next = (lane->to + 1) % 65536;
  if (next == lane->from) { fputs("the cable is full\n", stderr); exit(1); }
  lane->byte[lane->to] = byte;
  lane->at[lane->to] = at;
  lane->to = next;
}

/* Hands over what has arrived by now. */
static void deliver(struct lane *lane, int to, int64_t now) {
  uint8_t out[4096];
  size_t n = 0;
  while (lane->from != lane->to && lane->at[lane->from] <= now && n < sizeof out) {
    out[n++] = lane->byte[lane->from];
    lane->from = (lane->from + 1) % 65536;
  }
  if (n > 0 && write(to, out, n) != (ssize_t)n) die("write");
}

static void tell_settings(const struct termios2 *t) {
  static char last[64];
  char line[64];
  /* A pseudo-terminal clears PARENB, but Chromium sets INPCK exactly when it asked for parity. */
  snprintf(line, sizeof line, "%u %s %d %s", t->c_ospeed,
           !(t->c_iflag & INPCK) ? "none" : t->c_cflag & PARODD ? "odd" : "even",
           t->c_cflag & CSTOPB ? 2 : 1, t->c_cflag & CRTSCTS ? "hardware" : "none");
  if (strcmp(line, last)) puts(strcpy(last, line));
}

static _Noreturn void join(int argc, char **argv) {
  int echo = 0, pace = 0, slave[2];
  int64_t lump = 0;
  for (int i = 4; i < argc; i++) {
    echo |= !strcmp(argv[i], "echo");
    pace |= !strcmp(argv[i], "pace");
    if (!strncmp(argv[i], "lump=", 5)) lump = atoll(argv[i] + 5) * 1000000LL;
  }
  struct pollfd end[2] = {{make_end(argv[2], &slave[0]), POLLIN, 0}, {make_end(argv[3], &slave[1]), POLLIN, 0}};
  setvbuf(stdout, NULL, _IOLBF, 0);
  puts("ready");
  int64_t line_free = 0, wake;
  uint8_t in[4096];
  for (;;) {
    int64_t now = now_ns();
    wake = now + LOOK_NS;
    for (int to = 0; to < 2; to++)
      if (lanes[to].from != lanes[to].to && lanes[to].at[lanes[to].from] < wake) wake = lanes[to].at[lanes[to].from];
    int64_t wait = wake > now ? wake - now : 0;
    struct timespec time_out = {wait / 1000000000LL, wait % 1000000000LL};
    ppoll(end, 2, &time_out, NULL);
    /* Chromium sets TIOCEXCL, which outlives its close here and would refuse the next open. */
    ioctl(slave[PAGE], TIOCNXCL);
    struct termios2 t;
    ioctl(slave[PAGE], TCGETS2, &t);
    tell_settings(&t);
    now = now_ns();
    int bits = 10 + (t.c_iflag & INPCK ? 1 : 0) + (t.c_cflag & CSTOPB ? 1 : 0);
    int64_t character = pace && t.c_ospeed ? bits * 1000000000LL / t.c_ospeed : 0;
    for (int from = 0; from < 2; from++) {
      if (!(end[from].revents & POLLIN)) continue;
      ssize_t n = read(end[from].fd, in, sizeof in);
      for (ssize_t i = 0; i < n; i++) {
        line_free = (line_free > now ? line_free : now) + character;
        int64_t at = line_free;
        if (from == DEVICE && lump) at = (at / lump + 1) * lump;
        push(&lanes[!from], in[i], at);
        if (from == PAGE && echo) push(&lanes[PAGE], in[i], at);
      }
    }
    now = now_ns();
    deliver(&lanes[PAGE], end[PAGE].fd, now);
    deliver(&lanes[DEVICE], end[DEVICE].fd, now);
  }
}

static int uevent(int argc, char **argv) {
  struct { char prefix[8]; unsigned magic, header, offset, length, filters[4]; char body[4096]; } message =
      {"libudev", htonl(0xfeedcafe), 40, 40, 0, {0}, ""};
  for (int i = 2; i < argc; i++) {
    size_t n = strlen(argv[i]) + 1;
    if (message.length + n > sizeof message.body) return 64;
    memcpy(message.body + message.length, argv[i], n);
    message.length += n;
  }
  struct sockaddr_nl to = {.nl_family = AF_NETLINK, .nl_groups = 2}; /* the group that udevd sends to */
  int s = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_KOBJECT_UEVENT);
  if (s < 0 || sendto(s, &message, 40 + message.length, 0, (void *)&to, sizeof to) < 0) die("uevent");
  return 0;
}

int main(int argc, char **argv) {
  if (argc >= 4 && !strcmp(argv[1], "join")) join(argc, argv);
  if (argc >= 3 && !strcmp(argv[1], "uevent")) return uevent(argc, argv);
  fputs("usage: cable join PAGE_LINK DEVICE_LINK [echo] [pace] [lump=MILLISECONDS] | cable uevent KEY=VALUE...\n", stderr);
  return 64;
}
