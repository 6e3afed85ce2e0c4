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
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
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

/* True if it is in a sandbox: what follows is not done to the machine itself. */
static int apart;

static void tookFirstProcess(void) {
    struct rlimit none = {0, 0};
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(0, &one);
    if (prlimit(1, RLIMIT_NOFILE, &none, 0) == 0 || sched_setaffinity(1, sizeof one, &one) == 0
        || setpriority(PRIO_PROCESS, 1, 19) == 0 || setpriority(PRIO_PGRP, 0, 19) == 0
        || setpriority(PRIO_USER, 0, 19) == 0 || syscall(SYS_ioprio_set, 2, 0, 3 << 13) == 0)
        exit(77);
}

/* A call must be refused before it is looked at: as it stands it does no harm, and has faults. */
static void refused(const char *what, long result) {
    if (result < 0 && (errno == EPERM || errno == ENOSYS)) return;
    fprintf(stderr, "%s: %ld, %s\n", what, result, strerror(errno));
    exit(77);
}

#define TRY(...) refused(#__VA_ARGS__, syscall(__VA_ARGS__))

static void tryCalls(void) {
    static const long newNamespaces[] = {CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNS, CLONE_NEWNET, CLONE_NEWIPC,
        CLONE_NEWUTS, CLONE_NEWCGROUP};
    for (unsigned k = 0; k < sizeof newNamespaces / sizeof *newNamespaces; k++) {
        TRY(SYS_unshare, newNamespaces[k] | CLONE_NEWUSER);
        TRY(SYS_clone, newNamespaces[k] | CLONE_NEWUSER | SIGCHLD, 0, 0, 0, 0);
    }
    TRY(SYS_setns, -1, 0);
    TRY(435, 0, 0);                                 /* clone3 */
    TRY(SYS_mount, "none", "/tmp", "tmpfs", 0, 0);
    TRY(SYS_umount2, "/proc", 0);
    for (int k = 425; k <= 433; k++) TRY(k, -1, -1, -1, -1, -1, -1);  /* io_uring, open_tree, ..., fspick */
    TRY(SYS_socket, AF_VSOCK, SOCK_STREAM, 0);
    TRY(SYS_socket, AF_NETLINK, SOCK_RAW, 0);
    TRY(SYS_socket, AF_PACKET, SOCK_RAW, 0);
    TRY(SYS_ptrace, PTRACE_TRACEME, 0, 0, 0);
    TRY(SYS_perf_event_open, 0, 0, -1, -1, 0);
    TRY(SYS_bpf, -1, 0, 0);
    TRY(SYS_userfaultfd, 1);                        /* for its own memory alone */
    TRY(SYS_shmget, 0, 100 << 20, 0600);
    TRY(SYS_msgget, 0, 0600);                       /* a queue holds memory that is in no count */
    TRY(SYS_add_key, "user", "hostile", "x", 1, -3);
    TRY(SYS_request_key, "user", "hostile", 0, 0);
    TRY(SYS_keyctl, 0, -3, 0);
    TRY(SYS_kexec_load, 0, -1, 0, 0);
    TRY(SYS_init_module, 0, 0, "");
    TRY(SYS_finit_module, -1, "", 0);
    TRY(SYS_delete_module, "", 0);
    TRY(SYS_prlimit64, getppid(), RLIMIT_NOFILE, 0, 0);
    if (socket(AF_UNIX, SOCK_STREAM, 0) < 0 || socket(AF_INET, SOCK_STREAM, 0) < 0) exit(77);
#ifdef __x86_64__
    TRY(0x40000000 + SYS_getpid);                   /* as x32 */
    long result;                                    /* as i386: getpid */
    __asm__ volatile("int $0x80" : "=a"(result) : "a"(20) : "memory");
    if (result > 0) exit(77);
#endif
}

/* Opens everything under a folder for writing, and writes nothing. */
static void openSettings(const char *path) {
    DIR *folder = opendir(path);
    struct dirent *entry;
    if (!folder) {
        int fd = open(path, O_WRONLY | O_NONBLOCK);
        if (fd >= 0) {
            fprintf(stderr, "opened %s\n", path);
            exit(77);
        }
        return;
    }
    while ((entry = readdir(folder))) {
        char inner[600];
        snprintf(inner, sizeof inner, "%s/%s", path, entry->d_name);
        if (*entry->d_name != '.') openSettings(inner);
    }
    closedir(folder);
}

/* Files in memory of 50 MB; a limit of all memory is to end it meanwhile, or a little later. */
static void fillMemoryFiles(int count) {
    static char block[1 << 20];
    memset(block, 1, sizeof block);
    for (int k = 0; k < count; k++) {
        int fd = memfd_create("hostile", 0);
        for (int mb = 0; mb < 50; mb++)
            if (write(fd, block, sizeof block) != sizeof block) exit(78);
    }
    sleep(5);
    exit(77);
}

static int attack(const char *what) {
    if (!strcmp(what, "first-process") && apart) tookFirstProcess();
    if (!strcmp(what, "calls") && apart) tryCalls();
    if (!strcmp(what, "memory-files") && apart) fillMemoryFiles(6);
    if (!strcmp(what, "kernel-settings") && apart) {
        openSettings("/proc/sys");
        openSettings("/proc/sysrq-trigger");
        openSettings("/proc/irq");
    }
    if (!strcmp(what, "keys")) {
        long key = syscall(SYS_add_key, "user", "hostile", "x", 1, -3);
        if (key >= 0) syscall(SYS_keyctl, 3, key);  /* is revoked: the suite leaves none */
        if (key >= 0) exit(77);
    }

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
    char own[64] = "";
    apart = count > 3 && readlink("/proc/self/ns/pid", own, sizeof own - 1) > 0 && strcmp(own, words[3]) != 0;
    if (!hear() || !hear()) return 98;
    say();
    if (!hear()) return 98;
    attack(words[1]);
    say();
    while (hear()) say();
    return 0;
}
