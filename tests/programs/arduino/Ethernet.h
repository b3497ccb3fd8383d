#pragma once
#include "Arduino.h"

/* A server that answers as the table of the line says. */
class EthernetClient : public Line {
public:
    EthernetClient()
    {
        half_duplex = false;
        answers = Serial1.answers;
        many = Serial1.many;
    }
    int connect(const char *host, uint16_t port)
    {
        printf("connect %s %u\n", host, port);
        open = true;
        return 1;
    }
    uint8_t connected() { return open; }

private:
    bool open = false;
};

class EthernetClass {
public:
    void begin(uint8_t *) {}
};
extern EthernetClass Ethernet;
