/* Loaded into Firefox, which takes a file for a serial port only if it has modem lines; a pseudo-terminal has none.
 * Where the kernel says so, this says that all are on and takes every change of them. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdarg.h>
#include <sys/ioctl.h>
#include <unistd.h>

int ioctl(int file, unsigned long request, ...) {
  static int (*kernel)(int, unsigned long, void *);
  if (!kernel) *(void **)&kernel = dlsym(RTLD_NEXT, "ioctl");
  va_list rest;
  va_start(rest, request);
  void *argument = va_arg(rest, void *);
  va_end(rest);
  int answer = kernel(file, request, argument);
  if (answer >= 0 || (errno != ENOTTY && errno != EINVAL) || !isatty(file)) return answer;
  if (request == TIOCMGET) *(int *)argument = TIOCM_CTS | TIOCM_DSR | TIOCM_CAR;
  else if (request != TIOCMSET && request != TIOCMBIS && request != TIOCMBIC) return answer;
  return 0;
}
