/*
 * Starts a bot in a sandbox. One program in place of setsid, unshare, a shell and setpriv, because starting a program
 * takes longer than all that they do.
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
 *   -c FILE         joins the control group whose cgroup.procs this is
 *   -m -p -f -o N   limits: bytes of address space, processes, bytes of a file, open files
 *
 * light: this process waits outside; its child, the first process of the PID namespace, mounts /proc, gives up all
 * capabilities and waits; the bot is the child of that. Both close the streams of the bot after the fork, so that the
 * end of a stream is seen when the bot closes it, and exit as the bot did: with its status, or 128 and its signal.
 * Neither can be ended by the bot: the one outside ignores the signals that reach its group, and in the group the bot
 * has only SIGKILL left, which ends the bot as well; the first process takes no signal from inside.
 *
 * Status 127: the command was not found; 126: it cannot be executed; 125: a step of the sandbox failed.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <net/if.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef PR_CAP_AMBIENT
#define PR_CAP_AMBIENT 47
#define PR_CAP_AMBIENT_CLEAR_ALL 4
#endif

static const char *uid = "65534", *gid = "65534", *group;
static int loopback;
static const char *readOnly[64];
static int readOnlyCount;
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

/* Lets go of the streams, waits for a child, reaps others, and exits as the child did. */
static void waitFor(pid_t child) {
    int status;
    close(0);
    close(1);
    close(2);
    for (;;) {
        pid_t ended = wait(&status);
        if (ended == child) {
            _exit(WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status));
        }
        if (ended < 0 && errno != EINTR) {
            _exit(125);
        }
    }
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
    int namespaces = open("/proc/sys/user/max_cgroup_namespaces", O_WRONLY | O_CLOEXEC);
    if (namespaces >= 0) {                          /* with one of its own the bot could mount them again */
        if (write(namespaces, "0", 1) < 0) {
            fail("control groups");
        }
        close(namespaces);
    }
    if (loopback) {
        bringUpLoopback();
    }
    dropCapabilities();
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);             /* the bot must not be able to attach to this process */
    pid_t bot = fork();
    if (bot < 0) {
        fail("fork");
    }
    if (bot > 0) {
        waitFor(bot);
    }
    signals(SIG_DFL);
    run(command);
}

static void move(int from, int to) {
    if (dup2(from, to) != to || close(from) != 0) {
        fail("streams");
    }
}

/* What started this one ends it when it ends itself; the bot must not be able to attach to it and undo that. */
static void inside(char **command) {
    prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
    pid_t bot = fork();
    if (bot < 0) {
        fail("fork");
    }
    if (bot > 0) {
        close(3);
        close(4);
        waitFor(bot);
    }
    move(3, 0);
    move(4, 1);
    run(command);
}

static void moveOutside(void) {
    move(0, 3);
    move(1, 4);
    int nothing = open("/dev/null", O_RDWR);
    if (nothing != 0 || dup2(0, 1) != 1) {
        fail("/dev/null");
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
        char *value = words[++at];
        if (letter == 'u') {
            uid = value;
        } else if (letter == 'g') {
            gid = value;
        } else if (letter == 'c') {
            group = value;
        } else if (letter == 'r' && readOnlyCount < (int) (sizeof readOnly / sizeof *readOnly)) {
            readOnly[readOnlyCount++] = value;
        } else if ((kind = strchr(kinds, letter)) != NULL) {
            limits[kind - kinds] = strtoull(value, NULL, 10);
        }
    }
    char **command = words + at + 1;
    if (at + 1 >= count) {
        fprintf(stderr, "sandbox: there is no command\n");
        return 125;
    }
    if (strcmp(mode, "inside") == 0) {
        inside(command);
    }
    setsid();
    if (group != NULL) {
        put(group, "0");
    }
    if (strcmp(mode, "light") == 0) {
        light(command);
    }
    if (strcmp(mode, "outside") == 0) {
        moveOutside();
    }
    run(command);
}
