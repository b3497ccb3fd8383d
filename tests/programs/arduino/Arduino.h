/* Stands in for Arduino's core: the clock is simulated and goes on with each look at it; `Serial` is standard output; `Serial1` is
   a line on which a table plays the device. What the transceiver would refuse ends the test. */
#pragma once
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PROGMEM
#define pgm_read_byte(address) (*(const uint8_t *)(address))
#define pgm_read_word(address) (*(const uint16_t *)(address))
#define pgm_read_dword(address) (*(const uint32_t *)(address))
#define memcpy_P memcpy
class __FlashStringHelper;
#define F(text) (reinterpret_cast<const __FlashStringHelper *>(text))
#define HIGH 1
#define LOW 0
#define OUTPUT 1
#define SERIAL_8N1 0x06
#define SERIAL_8N2 0x0E
#define SERIAL_8E1 0x26
#define SERIAL_8O1 0x36
#define SERIAL_7E1 0x24
/* As Arduino has them: they replace calls, whatever is called so. */
#define bit(b) (1UL << (b))
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define abs(x) ((x) > 0 ? (x) : -(x))
typedef uint8_t byte;
typedef uint16_t word;
typedef bool boolean;

/* Microseconds. */
extern unsigned long long simulated_now;
extern int direction;

inline unsigned long millis()
{
    simulated_now += 20;
    return (unsigned long)(simulated_now / 1000);
}
inline void delay(unsigned long duration) { simulated_now += duration * 1000ULL; }
inline void pinMode(uint8_t, uint8_t) {}
inline void digitalWrite(uint8_t, uint8_t value) { direction = value; }

class Print {
public:
    void print(const char *text) { printf("%s", text); }
    void print(const __FlashStringHelper *text) { printf("%s", reinterpret_cast<const char *>(text)); }
    void print(int value) { printf("%d", value); }
    void print(unsigned value) { printf("%u", value); }
    void print(long value) { printf("%ld", value); }
    void print(unsigned long value) { printf("%lu", value); }
    void print(double value) { printf("%.2f", value); }
    template <typename Value> void println(Value value)
    {
        print(value);
        printf("\n");
    }
};

/* What the device does when it has received a request: after a silence it sends some bytes. */
struct Answer {
    unsigned long long after;
    size_t length;
    uint8_t bytes[600];
};

class Line : public Print {
public:
    const Answer *answers = NULL;
    size_t many = 0;
    unsigned long long character = 573;
    bool half_duplex = true;

    void begin(unsigned long baud, int format = SERIAL_8N1)
    {
        character = 11000000ULL / baud;
        if (half_duplex) {
            printf("begin %lu %02X\n", baud, format);
        }
    }
    size_t write(const uint8_t *bytes, size_t length)
    {
        if (half_duplex && direction != HIGH) {
            printf("sent without direction\n");
            exit(1);
        }
        printf("sent ");
        for (size_t i = 0; i < length; i++) {
            printf("%02X", bytes[i]);
        }
        printf("\n");
        simulated_now += half_duplex ? character * length : 100;
        began = simulated_now;
        at = 0;
        answer = many > 0 ? answers++ : NULL;
        many -= many > 0;
        return length;
    }
    void flush() {}
    int available()
    {
        simulated_now += 10;
        if (answer == NULL || at >= answer->length) {
            return 0;
        }
        if (half_duplex && direction != LOW) {
            printf("not listening\n");
            exit(1);
        }
        return simulated_now >= began + answer->after + character * (at + 1) ? 1 : 0;
    }
    int read() { return answer != NULL && at < answer->length ? answer->bytes[at++] : -1; }

private:
    const Answer *answer = NULL;
    unsigned long long began = 0;
    size_t at = 0;
};

class Monitor : public Print {
public:
    void begin(unsigned long) {}
};

extern Monitor Serial;
extern Line Serial1;
