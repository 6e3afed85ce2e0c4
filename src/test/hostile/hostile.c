/*
 * A bot that attacks by system calls that a shell does not have, as its first argument says, when it is asked for the
 * second time; the second argument marks its processes. Chains and memory are bounded. What survives plays on.
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static const char answer[] = "{\"pods\":[{\"x\":8000,\"y\":4500,\"thrust\":50}]}\n";
static const char *mark;

static void say(void) {
    if (write(1, answer, sizeof answer - 1) < 0) exit(98);
}

/* Reads one line; 0 at the end. */
static int hear(void) {
    char c;
    while (read(0, &c, 1) == 1)
        if (c == '\n') return 1;
    return 0;
}

static void stay(void) {
    for (;;) pause();
}

static void quiet(void) {
    int null = open("/dev/null", O_RDWR);
    for (int fd = 0; fd < 3; fd++) dup2(null, fd);
}

/* The first process with the mark and a word in its command line that is not this program; 0 for none. */
static pid_t marked(const char *word) {
    DIR *proc = opendir("/proc");
    struct dirent *entry;
    pid_t found = 0;
    while (proc && !found && (entry = readdir(proc))) {
        char path[300], line[8192];
        snprintf(path, sizeof path, "/proc/%s/cmdline", entry->d_name);
        int fd = atoi(entry->d_name) ? open(path, O_RDONLY) : -1;
        ssize_t n = fd < 0 ? 0 : read(fd, line, sizeof line - 1);
        if (fd >= 0) close(fd);
        if (n > 0 && memmem(line, n, mark, strlen(mark)) && memmem(line, n, word, strlen(word)))
            found = atoi(entry->d_name);
    }
    if (proc) closedir(proc);
    return found;
}

/* A process of a session of its own whose parents are gone. */
static void escape(void) {
    pid_t child = fork();
    if (child == 0) {
        setsid();
        if (fork() == 0) {
            quiet();
            stay();
        }
        _exit(0);
    }
    waitpid(child, 0, 0);
}

/* Each process starts the next and ends; the last of them stays. */
static void chain(int length, int sessions) {
    if (fork() != 0) return;
    quiet();
    for (int k = 0; k < length; k++) {
        if (sessions) setsid();
        struct timespec step = {0, 2000000};
        nanosleep(&step, 0);
        if (fork() > 0) _exit(0);
    }
    stay();
}

static void *spin(void *unused) {
    for (volatile int go = 1; go;) ;
    return unused;
}

/* Answers as late as it can, by steps of parts of a millisecond, until that was too late. */
static void late(long limit_ns) {
    for (long spare = 4000000;; spare -= 200000) {
        struct timespec rest = {(limit_ns - spare) / 1000000000, (limit_ns - spare) % 1000000000};
        nanosleep(&rest, 0);
        say();
        if (!hear()) exit(0);
    }
}

static int attack(const char *what) {
    if (!strcmp(what, "late")) late(75000000);
    if (!strcmp(what, "double-fork")) escape();
    if (!strcmp(what, "chain")) chain(50, 0);
    if (!strcmp(what, "chain-sessions")) chain(50, 1);
    if (!strcmp(what, "no-death-signal")) {
        prctl(PR_SET_PDEATHSIG, 0);
        prctl(PR_SET_DUMPABLE, 0);
        escape();
    }
    if (!strcmp(what, "nested-namespace")) {
        /* Its processes must go with the bot, although they are in a namespace within. */
        if (unshare(CLONE_NEWUSER | CLONE_NEWPID) == 0 && fork() == 0) {
            setsid();
            quiet();
            stay();
        }
    }
    if (!strcmp(what, "memory")) {
        for (int k = 0; k < 300; k++) {
            char *part = mmap(0, 1 << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            if (part == MAP_FAILED) break;
            memset(part, k + 1, 1 << 20);
        }
    }
    if (!strcmp(what, "descriptors")) {
        for (int k = 0; k < 3000; k++)
            if (open("/dev/null", O_RDONLY) < 0) break;
    }
    if (!strcmp(what, "threads")) {
        pthread_t thread;
        for (int k = 0; k < 4; k++) pthread_create(&thread, 0, spin, 0);
    }
    if (!strcmp(what, "crash")) *(volatile int *) 0 = 1;
    if (!strcmp(what, "reads-memory")) {
        char byte;
        char path[64];
        pid_t pid = marked("honest.sh");
        snprintf(path, sizeof path, "/proc/%d/mem", pid);
        if (pid && open(path, O_RDONLY) >= 0) exit(77);
        struct iovec here = {&byte, 1}, there = {(void *) answer, 1};
        if (pid && (process_vm_readv(pid, &here, 1, &there, 1, 0) == 1)) exit(77);
    }
    if (!strcmp(what, "traces")) {
        pid_t pid = marked("honest.sh");
        if (pid && ptrace(PTRACE_SEIZE, pid, 0, 0) == 0) exit(77);
    }
    if (!strcmp(what, "blocks-signals")) {
        sigset_t all;
        sigfillset(&all);
        sigprocmask(SIG_BLOCK, &all, 0);
        for (int k = 1; k < 65; k++) signal(k, SIG_IGN);
        stay();
    }
    return 0;
}

int main(int count, char **words) {
    if (count < 3) return 99;
    mark = words[2];
    if (!hear() || !hear()) return 98;
    say();
    if (!hear()) return 98;
    attack(words[1]);
    say();
    while (hear()) say();
    return 0;
}
