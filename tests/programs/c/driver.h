/* Runs the routines of the program that is included before: prints all frames, then checks the replies that standard input
   gives, each as the number of its request, from 0, and pairs of hexadecimal digits, or "-". */
#include <stdio.h>

static unsigned digit(char c)
{
    return (unsigned)(c <= '9' ? c - '0' : c - 'A' + 10);
}

static void drive(void)
{
    static uint8_t request[2048], reply[2048];
    static char text[4096];
    int number;
    for (unsigned i = 0; i < sizeof requests / sizeof requests[0]; i++) {
        int length = requests[i]->make(request);
        for (int at = 0; at < length; at++) {
            printf("%02X", request[at]);
        }
        printf("\n");
    }
    while (scanf("%d %4095s", &number, text) == 2) {
        int length = 0;
        if (text[0] != '-') {
            for (; text[2 * length] != '\0'; length++) {
                reply[length] = (uint8_t)(digit(text[2 * length]) * 16 + digit(text[2 * length + 1]));
            }
        }
        requests[number]->make(request);
        printf("#\n");
        fflush(stdout);
        requests[number]->show(request, reply, length);
    }
}
