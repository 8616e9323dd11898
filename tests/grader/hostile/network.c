/* passed: it looks for a network, and for sockets without a file */
/* earns: all */
#define _GNU_SOURCE
#include "exercise.h"
#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

static void knock(const char *address, int port)
{
    struct sockaddr_in to = {.sin_family = AF_INET,
                             .sin_port = htons((unsigned short)port)};
    const int plug = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    inet_pton(AF_INET, address, &to.sin_addr);
    if (plug >= 0 &&
        connect(plug, (const struct sockaddr *)&to, sizeof to) == 0)
        printf("BROKEN: %s:%d answers\n", address, port);
}

static void count_lines(const char *path, int most)
{
    char line[1024];
    int lines = 0;
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file))
        ++lines;
    if (file)
        fclose(file);
    if (lines > most)
        printf("BROKEN: %s has %d lines\n", path, lines);
}

static void trick(void)
{
    static const int ports[] = {22, 53, 80, 111, 443, 631, 8080, 2375};
    struct sockaddr_in away = {.sin_family = AF_INET,
                               .sin_port = htons(53)};
    const int plug = socket(AF_INET, SOCK_DGRAM, 0);
    for (int i = 0; i < 8; ++i)
        knock("127.0.0.1", ports[i]);
    inet_pton(AF_INET, "9.9.9.9", &away.sin_addr);
    if (plug >= 0 && sendto(plug, "x", 1, 0, (const struct sockaddr *)&away,
                            sizeof away) > 0)
        printf("BROKEN: a datagram went out\n");
    count_lines("/proc/net/dev", 3);
    count_lines("/proc/net/route", 1);
    count_lines("/proc/net/unix", 1);
}
