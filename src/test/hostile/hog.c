/*
 * A bot that burns processors while its opponent is asked, from its second turn on, as its first argument says; the
 * second is for how many milliseconds it searches in each turn of its own. It answers well otherwise.
 */
#define _GNU_SOURCE
#include <sched.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <time.h>
#include <unistd.h>

static volatile double *answeredAt;                 /* shared with the children, in milliseconds */
static volatile unsigned long work;

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1e3 + time.tv_nsec / 1e6;
}

/* The ends of a pipe on which a child that has begun is at its end. */
static int begun[2];

static void burnFor(double ms) {
    for (double end = now() + ms; now() < end;)
        for (int k = 0; k < 1000; k++) work += k;
}

static void burn(void) {
    for (;;) work++;
}

static void burnAndRest(void) {
    for (;;) {
        burnFor(90);
        usleep(60000);
    }
}

/* Sleeps until the opponent is asked, and burns for as long as that may take. */
static void burnInItsTurn(void) {
    for (double last = 0;;) {
        usleep(1000);
        if (*answeredAt == last || now() < *answeredAt + 5) continue;
        last = *answeredAt;
        while (now() < last + 70) work++;
    }
}

static double linkMs = 5;                           /* how long each process of a chain burns */

static void forkOn(void) {
    for (;;) {
        burnFor(linkMs);
        if (fork() > 0) _exit(0);
        setsid();
    }
}

/* A chain whose processes nobody waits for: their times are in no count when they have ended. */
static void forkOnUnseen(void) {
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    signal(SIGCHLD, SIG_IGN);
    if (fork() == 0) forkOn();
    close(begun[1]);
    for (;;) pause();
}

static void goOn(int number) {
    work += number;
}

static void burnAtSigcont(void) {
    signal(SIGCONT, goOn);
    burn();
}

static void moveMemory(void) {
    size_t size = 32 << 20;
    char *one = malloc(size), *other = malloc(size);
    for (int k = 0; one && other; k++) {
        memset(one, k, size);
        memcpy(other, one, size);
    }
}

/* A timer that sends SIGCONT lets a stopped process go on, and is spent by that: here are many. */
static void freeItself(void) {
    struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGCONT};
    signal(SIGCONT, goOn);
    for (int k = 1; k <= 200; k++) {
        timer_t timer;
        long at = k * 5000000L;
        struct itimerspec each = {{1, 0}, {at / 1000000000, at % 1000000000}};
        timer_create(CLOCK_MONOTONIC, &event, &timer);
        timer_settime(timer, 0, &each, NULL);
    }
    close(begun[1]);
    burn();
}

static void burnInNamespaces(void) {
    if (unshare(CLONE_NEWUSER | CLONE_NEWPID) == 0 && fork() > 0) _exit(0);
    burn();
}

static struct {
    const char *word;
    int children;
    void (*hog)(void);
} kinds[] = {{"none", 0, burn}, {"own", 0, burn}, {"hogs", 16, burn}, {"many", 64, burn}, {"forks", 16, forkOn},
    {"sigcont", 16, burnAtSigcont}, {"pulse", 16, burnAndRest}, {"sleeper", 16, burnInItsTurn},
    {"memory", 16, moveMemory}, {"namespaces", 16, burnInNamespaces}, {"timer", 16, freeItself},
    {"chain", 0, forkOn}, {"lost", 0, forkOnUnseen}};

/* Starts the children of a word, or of one such as chain-4-2: 4 of them, and 2 ms; they have begun when it returns, so that holding them does not come before. */
static void start(const char *word) {
    char none, kind[16];
    int count = 0;
    if (pipe(begun)) abort();
    if (sscanf(word, "%15[a-z]-%d-%lf", kind, &count, &linkMs) == 3) word = kind;
    for (unsigned k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        for (int child = 0; strcmp(word, kinds[k].word) == 0 && child < kinds[k].children + count; child++) {
            if (fork() == 0) {
                setsid();
                close(0);
                close(1);
                close(begun[0]);
                if (kinds[k].hog != freeItself) close(begun[1]);
                kinds[k].hog();
            }
        }
    }
    close(begun[1]);
    while (read(begun[0], &none, 1) > 0) {}
    close(begun[0]);
}

/* Searches on so many threads at once, in its own turn, for a time. */
static void search(int threads, double ms) {
    for (int k = 1; k < threads; k++) {
        if (fork() == 0) {
            burnFor(ms);
            _exit(0);
        }
    }
    burnFor(ms);
}

int main(int count, char **words) {
    static const char answer[] = "{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":50}]}";
    const char *word = count > 1 ? words[1] : "none";
    double ms = count > 2 ? atof(words[2]) : 0;
    char line[1 << 16];
    signal(SIGCHLD, SIG_IGN);
    answeredAt = mmap(NULL, sizeof *answeredAt, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    for (int turn = 0; fgets(line, sizeof line, stdin); turn++) {
        if (turn == 2) start(word);
        if (turn == 0 || strncmp(line, "{\"type\":\"end\"", 13) == 0) continue;
        search(strcmp(word, "own") == 0 ? 16 : 1, ms);
        puts(answer);
        fflush(stdout);
        *answeredAt = now();
    }
}
