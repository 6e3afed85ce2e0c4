/*
 * Starts a bot in a sandbox. One program in place of setsid, unshare, a shell and setpriv, because starting a program
 * takes longer than all that they do; one file, long as it is, because a compiler makes it on the machine of its user.
 *
 *   launch off     OPTIONS -- COMMAND...   a session of its own
 *   launch light   OPTIONS -- COMMAND...   also namespaces of its own, without capabilities
 *   launch outside OPTIONS -- COMMAND...   a session of its own; the streams of the bot become descriptors 3 and 4
 *   launch inside  OPTIONS -- COMMAND...   the first process of a namespace, whose child is the bot; descriptors 3 and 4
 *                                          become its streams
 *
 *   -u UID -g GID   what the user is in the user namespace (light)
 *   -l              brings up the loopback device (light)
 *   -r FOLDER       a mount point that the bot must not write to; can be repeated (light)
 *   -b FILE         a file that the bot must not write to; can be repeated (light)
 *   -e FOLDER       a folder that is made if it is not there, and of which the bot has an empty one of its own, for 64 MiB;
 *                   can be repeated (light)
 *   -s SOCKET       a Unix socket on which the referee listens; its folder is hidden from the bot (light, outside)
 *   -h              descriptor 5 is that socket, connected (inside)
 *   -c FILE         joins the control group whose cgroup.procs this is
 *   -m -p -f -o N   limits: bytes of address space, processes, bytes of a file, open files
 *
 * light: this process waits outside; its child, the first process of the PID namespace, mounts /proc, gives up all
 * capabilities and waits; the bot is the child of that. Both close the streams of the bot after the fork, so that the
 * end of a stream is seen when the bot closes it, and exit as the bot did: with its status, or 128 and its signal.
 * Neither can be ended by the bot: the one outside ignores the signals that reach its group, and in the group the bot
 * has only SIGKILL left, which ends the bot as well; the first process takes no signal from inside.
 *
 * With a socket the first process of the namespace stops everything in it when the referee sends the byte 'h' (hold),
 * and lets it go on at 'c' (continue); it sends the byte back when that is done. The socket is connected before there
 * are namespaces, and the bot never has it. No privilege is needed: all processes of the bot are the user's own.
 *
 * A bot in a namespace has a keyring of its own and one filter of system calls, see confine(); nothing that the bot can
 * set of the first process keeps that from serving the socket.
 *
 * Status 127: the command was not found; 126: it cannot be executed; 125: a step of the sandbox failed, or there are no
 * words; 124: there are no words, and no filter of system calls can be set here.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/keyctl.h>
#include <linux/seccomp.h>
#include <net/if.h>
#include <sched.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef SECCOMP_FILTER_FLAG_SPEC_ALLOW
#define SECCOMP_FILTER_FLAG_SPEC_ALLOW 4
#endif
#ifndef PR_CAP_AMBIENT
#define PR_CAP_AMBIENT 47
#define PR_CAP_AMBIENT_CLEAR_ALL 4
#endif

static const char *uid = "65534", *gid = "65534", *group;
static const char *holdSocket;
static int holding = -1;                            /* the connected socket */
static int loopback;
static const char *readOnly[64], *emptied[8], *closedFiles[4096];
static int readOnlyCount, emptiedCount, closedFileCount;
static rlim_t limits[4];
static const int resources[4] = {RLIMIT_AS, RLIMIT_NPROC, RLIMIT_FSIZE, RLIMIT_NOFILE};

static void fail(const char *what) {
    fprintf(stderr, "sandbox: %s: %s\n", what, strerror(errno));
    _exit(125);
}

static void put(const char *file, const char *text) {
    int descriptor = open(file, O_WRONLY | O_CLOEXEC);
    if (descriptor < 0 || write(descriptor, text, strlen(text)) < 0) {
        fail(file);
    }
    close(descriptor);
}

static void map(const char *file, const char *inside, unsigned outside) {
    char line[64];
    snprintf(line, sizeof line, "%s %u 1", inside, outside);
    put(file, line);
}

/* The bot gets the dispositions that a program usually starts with, whatever this process ignores. */
static void signals(void (*disposition)(int)) {
    static const int all[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGALRM, SIGUSR1, SIGUSR2, SIGTSTP, SIGTTIN,
        SIGTTOU, SIGCONT, SIGVTALRM, SIGPROF, SIGIO, SIGXCPU, SIGXFSZ};
    for (unsigned k = 0; k < sizeof all / sizeof *all; k++) {
        signal(all[k], disposition);
    }
}

#if defined(__x86_64__)
#define ARCHITECTURE AUDIT_ARCH_X86_64
#elif defined(__aarch64__)
#define ARCHITECTURE AUDIT_ARCH_AARCH64
#elif defined(__riscv) && __riscv_xlen == 64
#define ARCHITECTURE AUDIT_ARCH_RISCV64
#else
#define ARCHITECTURE 0                              /* without a filter */
#endif

#define REFUSED (SECCOMP_RET_ERRNO | EPERM)
#define ABSENT (SECCOMP_RET_ERRNO | ENOSYS)
#define NAMESPACES (CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID \
    | CLONE_NEWNET)
#define TIME_NAMESPACE 0x80
#define X32 0x40000000
#define ALWAYS 0, 0, 0

/*
 * Answers to system calls, by the lower half of an argument: the first rule that fits decides, and what has none is
 * allowed. The first process of the namespace is number 1, and among those of a group and of a user. Numbers from 424
 * on are those of all architectures.
 */
static struct rule {
    unsigned call, argument;
    unsigned short test;
    unsigned value, answer;
} rules[] = {
    {SYS_prlimit64, 0, BPF_JEQ, 0, SECCOMP_RET_ALLOW}, {SYS_prlimit64, ALWAYS, REFUSED},
    {SYS_setpriority, 1, BPF_JEQ, 1, REFUSED}, {SYS_setpriority, 0, BPF_JEQ, 0, SECCOMP_RET_ALLOW},
    {SYS_setpriority, ALWAYS, REFUSED},
    {SYS_ioprio_set, 1, BPF_JEQ, 1, REFUSED}, {SYS_ioprio_set, 0, BPF_JEQ, 1, SECCOMP_RET_ALLOW},
    {SYS_ioprio_set, ALWAYS, REFUSED},
    {SYS_sched_setaffinity, 0, BPF_JEQ, 1, REFUSED}, {SYS_sched_setattr, 0, BPF_JEQ, 1, REFUSED},
    {SYS_sched_setparam, 0, BPF_JEQ, 1, REFUSED}, {SYS_sched_setscheduler, 0, BPF_JEQ, 1, REFUSED},
    {SYS_socket, 0, BPF_JEQ, AF_UNIX, SECCOMP_RET_ALLOW}, {SYS_socket, 0, BPF_JEQ, AF_INET, SECCOMP_RET_ALLOW},
    {SYS_socket, 0, BPF_JEQ, AF_INET6, SECCOMP_RET_ALLOW}, {SYS_socket, ALWAYS, REFUSED},
    {SYS_socketpair, 0, BPF_JEQ, AF_UNIX, SECCOMP_RET_ALLOW}, {SYS_socketpair, ALWAYS, REFUSED},
    {SYS_clone, 0, BPF_JSET, NAMESPACES, REFUSED}, {SYS_unshare, 0, BPF_JSET, NAMESPACES | TIME_NAMESPACE, REFUSED},
    {435 /* clone3: its flags are in memory */, ALWAYS, ABSENT}, {SYS_setns, ALWAYS, REFUSED},
    {SYS_add_key, ALWAYS, REFUSED}, {SYS_keyctl, ALWAYS, REFUSED}, {SYS_request_key, ALWAYS, REFUSED},
    {SYS_mount, ALWAYS, REFUSED}, {SYS_umount2, ALWAYS, REFUSED}, {SYS_pivot_root, ALWAYS, REFUSED},
    {428 /* open_tree */, ALWAYS, REFUSED}, {429 /* move_mount */, ALWAYS, REFUSED},
    {430 /* fsopen */, ALWAYS, REFUSED}, {431, ALWAYS, REFUSED}, {432, ALWAYS, REFUSED}, {433, ALWAYS, REFUSED},
    {442 /* mount_setattr */, ALWAYS, REFUSED}, {467 /* open_tree_attr */, ALWAYS, REFUSED},
    {425 /* io_uring_setup */, ALWAYS, REFUSED}, {426, ALWAYS, REFUSED}, {427, ALWAYS, REFUSED},
    {SYS_ptrace, ALWAYS, REFUSED}, {SYS_perf_event_open, ALWAYS, REFUSED}, {SYS_bpf, ALWAYS, REFUSED},
    {SYS_userfaultfd, ALWAYS, REFUSED}, {SYS_shmget, ALWAYS, REFUSED}, {SYS_msgget, ALWAYS, REFUSED},
    {SYS_init_module, ALWAYS, REFUSED},
    {SYS_finit_module, ALWAYS, REFUSED}, {SYS_delete_module, ALWAYS, REFUSED},
#ifdef SYS_kexec_file_load
    {SYS_kexec_file_load, ALWAYS, REFUSED},
#endif
    {SYS_kexec_load, ALWAYS, REFUSED},
};
#define RULES (int) (sizeof rules / sizeof *rules)

static struct sock_filter code[512];
static unsigned short length;

static void add(unsigned short operation, unsigned value, unsigned char yes, unsigned char no) {
    code[length++] = (struct sock_filter) {operation, yes, no, value};
}

static void load(size_t offset) {
    add(BPF_LD | BPF_W | BPF_ABS, offset, 0, 0);
}

static void answer(unsigned value) {
    add(BPF_RET | BPF_K, value, 0, 0);
}

/* Adds the answers of sorted rules, as a tree: the kernel tries the filter with each call when it is set. */
static void addRules(int from, int to) {
    int middle = (from + to) / 2;
    while (middle > from && rules[middle].call == rules[middle - 1].call) {
        middle--;
    }
    if (to - from > 4 && middle > from) {
        int jump = length;
        add(BPF_JMP | BPF_JGE | BPF_K, rules[middle].call, 0, 0);
        addRules(from, middle);
        code[jump].jt = length - jump - 1;
        addRules(middle, to);
        return;
    }
    for (int k = from; k < to; k++) {
        add(BPF_JMP | BPF_JEQ | BPF_K, rules[k].call, 0, rules[k].test == 0 ? 1 : 4);
        if (rules[k].test != 0) {
            load(offsetof(struct seccomp_data, args) + rules[k].argument * sizeof (__u64));
            add(BPF_JMP | rules[k].test | BPF_K, rules[k].value, 0, 1);
        }
        answer(rules[k].answer);
        if (rules[k].test != 0) {
            load(offsetof(struct seccomp_data, nr));
        }
    }
    answer(SECCOMP_RET_ALLOW);
}

/* Sets the filter, for this process and all that it becomes and starts; 0 if that is done. */
static int filterCalls(void) {
    for (int k = 1; k < RULES; k++) {
        for (int at = k; at > 0 && rules[at].call < rules[at - 1].call; at--) {
            struct rule later = rules[at];
            rules[at] = rules[at - 1];
            rules[at - 1] = later;
        }
    }
    load(offsetof(struct seccomp_data, arch));
    add(BPF_JMP | BPF_JEQ | BPF_K, ARCHITECTURE, 1, 0);
    answer(REFUSED);
    load(offsetof(struct seccomp_data, nr));
    if (ARCHITECTURE == AUDIT_ARCH_X86_64) {
        add(BPF_JMP | BPF_JGE | BPF_K, X32, 0, 1);
        answer(REFUSED);
    }
    addRules(0, RULES);
    struct sock_fprog program = {length, code};
    if (ARCHITECTURE == 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        errno = ENOSYS;
        return -1;
    }
    /* Before Linux 5.16 a filter slows programs down against Spectre unless it says not to. */
    return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_SPEC_ALLOW, &program) == 0
        || (errno == EINVAL && prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0) ? 0 : -1;
}

/* Keys are shared by all processes of a session, and by those of a user. */
static void confine(void) {
    syscall(SYS_keyctl, KEYCTL_JOIN_SESSION_KEYRING, NULL);
    if (filterCalls() != 0 && errno != EINVAL && errno != ENOSYS) {
        fail("filter");
    }
}

static void run(char **command) {
    for (int k = 0; k < 4; k++) {
        struct rlimit now, limit = {limits[k], limits[k]};
        if (limits[k] > 0 && getrlimit(resources[k], &now) == 0 && limits[k] < now.rlim_max
                && setrlimit(resources[k], &limit) != 0) {
            fail("limit");
        }
    }
    execvp(command[0], command);
    fprintf(stderr, "sandbox: %s: %s\n", command[0], strerror(errno));
    _exit(errno == ENOENT ? 127 : 126);
}

static void exitAs(int status) {
    _exit(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
}

/* Lets go of the streams, waits for a child, reaps others, and exits as the child did. */
static void waitFor(pid_t child) {
    int status;
    close(0);
    close(1);
    close(2);
    for (;;) {
        pid_t ended = wait(&status);
        if (ended == child) {
            exitAs(status);
        }
        if (ended < 0 && errno != EINTR) {
            _exit(125);
        }
    }
}

static void connectToReferee(void) {
    struct sockaddr_un address = {AF_UNIX, ""};
    if (strlen(holdSocket) >= sizeof address.sun_path) {
        errno = ENAMETOOLONG;
        fail("socket");
    }
    strcpy(address.sun_path, holdSocket);
    int connected = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (connected < 0 || connect(connected, (struct sockaddr *) &address, sizeof address) != 0) {
        fail("socket");
    }
    holding = fcntl(connected, F_DUPFD_CLOEXEC, 10);    /* beyond the descriptors with a meaning */
    close(connected);
}

/* Only its user writes there. What cannot be a folder is left as it is: another user of this machine may have made it. */
static void emptyFolder(const char *folder) {
    struct stat found;
    mkdir(folder, 0755);
    if (lstat(folder, &found) == 0 && S_ISDIR(found.st_mode)
            && mount("tmpfs", folder, "tmpfs", MS_NOSUID | MS_NODEV | MS_NOEXEC, "size=64m,mode=755") != 0) {
        fail(folder);
    }
}

/* What the bot would find there are sockets of other bots. */
static void hideSockets(void) {
    char folder[sizeof ((struct sockaddr_un *) 0)->sun_path];
    strcpy(folder, holdSocket);
    *strrchr(folder, '/') = 0;
    if (mount("tmpfs", folder, "tmpfs", MS_RDONLY | MS_NOSUID | MS_NODEV | MS_NOEXEC, "size=4k,mode=0") != 0) {
        fail(folder);
    }
}

/* Stops every process of the namespace but this one, or lets all go on, as the referee says; false at its end. */
static int obey(void) {
    char order;
    ssize_t count = read(holding, &order, 1);
    if (count < 0) {
        return errno == EINTR;
    }
    if (count == 0) {
        return 0;
    }
    kill(-1, order == 'h' ? SIGSTOP : SIGCONT);
    return send(holding, &order, 1, MSG_NOSIGNAL) == 1;
}

static sigset_t outerSignals;
static int events = -1, childEnds;                  /* what the first process waits for */

static void expect(int descriptor) {
    struct epoll_event event = {.events = EPOLLIN, .data.fd = descriptor};
    if (descriptor < 0 || epoll_ctl(events, EPOLL_CTL_ADD, descriptor, &event) != 0) {
        fail("events");
    }
}

/* To be called before the bot is started: its end must not be missed, and what it does must not keep us from it. */
static void expectEvents(void) {
    struct sigaction onlyEnds = {.sa_handler = SIG_DFL, .sa_flags = SA_NOCLDSTOP};
    sigset_t childSignal;
    sigaction(SIGCHLD, &onlyEnds, NULL);
    sigemptyset(&childSignal);
    sigaddset(&childSignal, SIGCHLD);
    sigprocmask(SIG_BLOCK, &childSignal, &outerSignals);
    if (holding >= 0) {
        events = epoll_create1(EPOLL_CLOEXEC);
        expect(childEnds = signalfd(-1, &childSignal, SFD_CLOEXEC | SFD_NONBLOCK));
        expect(holding);
    }
}

/*
 * As waitFor, for the first process of a namespace, which meanwhile does what the referee says. A limit of open files
 * would keep poll from that.
 */
static void superviseBot(pid_t bot) {
    struct signalfd_siginfo ignored;
    struct epoll_event event;
    close(0);
    close(1);
    close(2);
    while (holding >= 0) {
        int status;
        for (pid_t ended = waitpid(-1, &status, WNOHANG); ended > 0; ended = waitpid(-1, &status, WNOHANG)) {
            if (ended == bot) {
                exitAs(status);
            }
        }
        int found = epoll_wait(events, &event, 1, -1);
        if (found < 0 ? errno != EINTR : event.data.fd == holding && !obey()) {
            break;
        }
        while (read(childEnds, &ignored, sizeof ignored) > 0) {
            continue;
        }
    }
    waitFor(bot);
}

static void bringUpLoopback(void) {
    struct ifreq device;
    int socketNumber = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    memset(&device, 0, sizeof device);
    strcpy(device.ifr_name, "lo");
    device.ifr_flags = IFF_UP | IFF_RUNNING;
    if (socketNumber < 0 || ioctl(socketNumber, SIOCSIFFLAGS, &device) != 0) {
        fail("loopback");
    }
    close(socketNumber);
}

static void dropCapabilities(void) {
    struct __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
    struct __user_cap_data_struct none[2];
    memset(none, 0, sizeof none);
    for (int k = 0; prctl(PR_CAPBSET_READ, k, 0, 0, 0) >= 0; k++) {
        if (prctl(PR_CAPBSET_DROP, k, 0, 0, 0) != 0) {
            fail("capabilities");
        }
    }
    prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
    if (syscall(SYS_capset, &header, none) != 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        fail("capabilities");
    }
}

/* By writing to control groups a bot could kill and stop others. The other properties of the mount are kept. */
static void closeForWriting(const char *point) {
    struct statvfs now;
    unsigned long flags = MS_REMOUNT | MS_BIND | MS_RDONLY;
    if (statvfs(point, &now) != 0) {
        return;                                     /* where this process cannot look, the bot cannot write */
    }
    flags |= (now.f_flag & ST_NOSUID ? MS_NOSUID : 0) | (now.f_flag & ST_NODEV ? MS_NODEV : 0)
        | (now.f_flag & ST_NOEXEC ? MS_NOEXEC : 0) | (now.f_flag & ST_NOATIME ? MS_NOATIME : 0)
        | (now.f_flag & ST_NODIRATIME ? MS_NODIRATIME : 0) | (now.f_flag & ST_RELATIME ? MS_RELATIME : 0);
    if (!(now.f_flag & ST_RDONLY) && mount(NULL, point, NULL, flags, NULL) != 0) {
        fail(point);
    }
}

/* Mounted over itself, a file can be neither written to nor replaced. */
static void closeFile(const char *file) {
    if (mount(file, file, NULL, MS_BIND, NULL) == 0) {
        closeForWriting(file);
    } else if (errno != ENOENT) {
        fail(file);
    }
}

static void light(char **command) {
    unsigned realUser = geteuid(), realGroup = getegid();
    if (unshare(CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNS | CLONE_NEWNET | CLONE_NEWIPC | CLONE_NEWUTS) != 0) {
        fail("namespaces");
    }
    put("/proc/self/setgroups", "deny");
    map("/proc/self/uid_map", uid, realUser);
    map("/proc/self/gid_map", gid, realGroup);
    signals(SIG_IGN);
    pid_t init = fork();
    if (init < 0) {
        fail("fork");
    }
    if (init > 0) {
        if (holding >= 0) {
            close(holding);
        }
        waitFor(init);
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    if (mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0
            || mount("proc", "/proc", "proc", MS_NOSUID | MS_NODEV | MS_NOEXEC, NULL) != 0) {
        fail("/proc");
    }
    for (int k = 0; k < readOnlyCount; k++) {
        closeForWriting(readOnly[k]);
    }
    for (int k = 0; k < closedFileCount; k++) {
        closeFile(closedFiles[k]);
    }
    for (int k = 0; k < emptiedCount; k++) {
        emptyFolder(emptied[k]);
    }
    if (holdSocket != NULL) {
        hideSockets();
    }
    int nested = open("/proc/sys/user/max_user_namespaces", O_WRONLY | O_CLOEXEC);
    if (nested >= 0) {                              /* in one of its own the bot could mount all that again */
        if (write(nested, "0", 1) < 0) {
            fail("namespaces");
        }
        close(nested);
    }
    closeForWriting("/proc");                       /* a bot of root could write to settings of the whole machine */
    if (loopback) {
        bringUpLoopback();
    }
    dropCapabilities();
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);             /* the bot must not be able to attach to this process */
    expectEvents();
    pid_t bot = vfork();                            /* which takes less: it executes the bot or ends */
    if (bot < 0) {
        fail("fork");
    }
    if (bot > 0) {
        superviseBot(bot);
    }
    sigprocmask(SIG_SETMASK, &outerSignals, NULL);
    signals(SIG_DFL);
    confine();
    run(command);
}

static void move(int from, int to) {
    if (dup2(from, to) != to || close(from) != 0) {
        fail("streams");
    }
}

/* What started this one ends it when it ends itself; the bot must not be able to attach to it and undo that. */
static void inside(char **command) {
    struct rlimit noCore = {0, 0};
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    if (holding >= 0 && fcntl(holding, F_SETFD, FD_CLOEXEC) != 0) {
        fail("socket");
    }
    expectEvents();
    pid_t bot = vfork();                            /* which takes less: it executes the bot or ends */
    if (bot < 0) {
        fail("fork");
    }
    if (bot > 0) {
        close(3);
        close(4);
        superviseBot(bot);
    }
    sigprocmask(SIG_SETMASK, &outerSignals, NULL);
    move(3, 0);
    move(4, 1);
    setrlimit(RLIMIT_CORE, &noCore);
    confine();
    run(command);
}

static void moveOutside(void) {
    move(0, 3);
    move(1, 4);
    int nothing = open("/dev/null", O_RDWR);
    if (nothing != 0 || dup2(0, 1) != 1) {
        fail("/dev/null");
    }
    if (holding >= 0 && dup2(holding, 5) != 5) {    /* without close-on-exec, for bwrap to hand on */
        fail("socket");
    }
}

int main(int count, char **words) {
    const char *kinds = "mpfo", *kind;
    const char *mode = count > 1 ? words[1] : "";
    int at = 2;
    for (; at + 1 < count && strcmp(words[at], "--") != 0; at++) {
        char letter = words[at][1];
        if (letter == 'l') {
            loopback = 1;
            continue;
        }
        if (letter == 'h') {
            holding = 5;
            continue;
        }
        char *value = words[++at];
        if (letter == 'u') {
            uid = value;
        } else if (letter == 'g') {
            gid = value;
        } else if (letter == 'c') {
            group = value;
        } else if (letter == 's') {
            holdSocket = value;
        } else if (letter == 'r' && readOnlyCount < (int) (sizeof readOnly / sizeof *readOnly)) {
            readOnly[readOnlyCount++] = value;
        } else if (letter == 'e' && emptiedCount < (int) (sizeof emptied / sizeof *emptied)) {
            emptied[emptiedCount++] = value;
        } else if (letter == 'b' && closedFileCount < (int) (sizeof closedFiles / sizeof *closedFiles)) {
            closedFiles[closedFileCount++] = value;
        } else if ((kind = strchr(kinds, letter)) != NULL) {
            limits[kind - kinds] = strtoull(value, NULL, 10);
        }
    }
    char **command = words + at + 1;
    if (at + 1 >= count) {
        fprintf(stderr, "sandbox: there is no command\n");
        return filterCalls() == 0 ? 125 : 124;
    }
    if (strcmp(mode, "inside") == 0) {
        inside(command);
    }
    setsid();
    if (group != NULL) {
        put(group, "0");
    }
    if (holdSocket != NULL) {
        connectToReferee();
    }
    if (strcmp(mode, "light") == 0) {
        light(command);
    }
    if (strcmp(mode, "outside") == 0) {
        moveOutside();
    }
    run(command);
}
