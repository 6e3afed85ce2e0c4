/*
 * The client of a resident referee: steward-referee and steward-play are this program under two names, and do what
 * `steward referee` and `steward play` do without starting a JVM. It hands its words over to a resident (`steward
 * resident`), and its streams, signals and status are those of the command. Without a resident it starts one, under a
 * lock; where anything is odd it becomes the plain launcher.
 *
 * A resident serves one user, folder, environment, installation, control group, affinity, set of limits and so on: the
 * name of its socket is a digest of them, so a client finds only a resident in which a match cannot differ. The folder
 * of the sockets is the user's alone, and each side looks at the user of the other.
 *
 * Frames, both ways: a letter, the length (4 bytes, the highest first), as many bytes.
 *
 *   to the resident     A  the call: for each standard stream 1 if it is a terminal, or 0; words, each with a NUL behind
 *                       i  bytes of the input that was asked for; none: its end
 *                       x  why the input cannot be read
 *                       o  an output is written; or the bytes say why it cannot be
 *                       s  a signal: its number, one byte
 *   to the client       O  E  for the standard output and error
 *                       I  input is wanted
 *                       X  the end: the status, one byte
 *
 * lib/steward-resident is this program as well: `steward resident` by hand, which is to have the same name of a socket.
 */
#define _GNU_SOURCE
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/personality.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <unistd.h>

#define MOST_RESIDENTS 4            /* of a user: further places and environments are served plainly */
#define BOOT_MS 20000               /* how long a resident may take until it serves */
#define MOST_BYTES (1 << 16)        /* of a frame */

extern char **environ;

static char home[PATH_MAX];         /* the installation */
static char folder[64];             /* of the sockets; a socket's path has 107 bytes at most */
static struct sockaddr_un address = {.sun_family = AF_UNIX};
static char **words;

/* ---- the name of the socket: FNV-1a of 128 bits; an accident has to be unlikely, attackers cannot reach the folder -- */

static unsigned __int128 digest = ((unsigned __int128) 0x6c62272e07bb0142ULL << 64) | 0x62b821756295c58dULL;

static void add(const void *bytes, size_t count) {
    const unsigned __int128 prime = ((unsigned __int128) 1 << 88) | 0x13b;
    for (size_t i = 0; i < count; i++) {
        digest = (digest ^ ((const unsigned char *) bytes)[i]) * prime;
    }
}

static void addText(const char *text) {
    add(text, strlen(text) + 1);
}

/* Adds a file of /proc/self whole, or its lines that begin with one of the words. Returns 0 if it cannot be read. */
static int addFile(const char *path, const char *const *beginnings) {
    char line[4096];
    FILE *file = fopen(path, "re");
    if (!file) {
        return 0;
    }
    while (fgets(line, sizeof line, file)) {
        int wanted = !beginnings;
        for (int i = 0; !wanted && beginnings[i]; i++) {
            wanted = !strncmp(line, beginnings[i], strlen(beginnings[i]));
        }
        if (wanted) {
            addText(line);
        }
    }
    return !fclose(file);
}

static int addLink(const char *path) {
    char target[PATH_MAX] = "";
    if (readlink(path, target, sizeof target - 1) < 0) {
        return 0;
    }
    addText(target);
    return 1;
}

/* A sum of texts, for what has no order: a folder, or an environment, which a shell writes in its own. */
static uint64_t sum;

static void addToSum(const char *text, const struct stat *file) {
    unsigned __int128 before = digest;
    addText(text);
    if (file) {
        add(&file->st_mtim, sizeof file->st_mtim);
        add(&file->st_size, sizeof file->st_size);
    }
    sum += (uint64_t) (digest >> 64) ^ (uint64_t) digest;
    digest = before;
}

/* The program's files. */
static int addInstallation(void) {
    char lib[PATH_MAX + 8];
    snprintf(lib, sizeof lib, "%s/lib", home);
    DIR *files = opendir(lib);
    if (!files) {
        return 0;
    }
    for (struct dirent *each; (each = readdir(files));) {
        struct stat file;
        if (each->d_name[0] != '.' && !fstatat(dirfd(files), each->d_name, &file, 0)) {
            addToSum(each->d_name, &file);
        }
    }
    closedir(files);
    addText(home);
    return 1;
}

/* All that a match can depend on besides its words. Returns 0 if something of it is not known. */
static int addPlace(void) {
    static const char *const status[] = {"Umask:", "Uid:", "Gid:", "Groups:", "SigBlk:", "SigIgn:", "Cap", "NoNewPrivs:",
        "Seccomp", "Cpus_allowed:", "Mems_allowed:", NULL};
    static const char *const namespaces[] = {"cgroup", "ipc", "mnt", "net", "pid", "user", "uts", NULL};
    static const char *const ofShells[] = {"_=", "SHLVL=", "PWD=", "OLDPWD=", NULL}; /* they change them at each call */
    char current[PATH_MAX], path[64];
    struct stat place;
    if (!addInstallation() || !getcwd(current, sizeof current) || stat(".", &place)) {
        return 0;
    }
    addText(current);
    add(&place.st_dev, sizeof place.st_dev);
    add(&place.st_ino, sizeof place.st_ino);
    for (char **variable = environ; *variable; variable++) {
        int wanted = 1;
        for (int i = 0; ofShells[i]; i++) {
            wanted &= strncmp(*variable, ofShells[i], strlen(ofShells[i])) != 0;
        }
        if (wanted) {
            addToSum(*variable, NULL);
        }
    }
    add(&sum, sizeof sum);
    for (int i = 0; namespaces[i]; i++) {
        snprintf(path, sizeof path, "/proc/self/ns/%s", namespaces[i]);
        if (!addLink(path)) {
            return 0;
        }
    }
    int scheduled[] = {getpriority(PRIO_PROCESS, 0), sched_getscheduler(0), personality(0xffffffff)};
    add(scheduled, sizeof scheduled);
    return addLink("/proc/self/root") && addFile("/proc/self/status", status) && addFile("/proc/self/limits", NULL)
        && addFile("/proc/self/cgroup", NULL) && addFile("/proc/self/oom_score_adj", NULL);
}

/* ---- the socket --------------------------------------------------------------------------------------------------- */

static int isDirectory(const char *path, int private) {
    struct stat found;
    return !lstat(path, &found) && S_ISDIR(found.st_mode)
        && (!private || (found.st_uid == geteuid() && !(found.st_mode & 077)));
}

/* The folder of the sockets, made if it is not there. Returns 0 if others could open it. */
static int findFolder(void) {
    const char *runtime = getenv("XDG_RUNTIME_DIR"), *cache = getenv("XDG_CACHE_HOME"), *user = getenv("HOME");
    char parent[PATH_MAX];
    int length;
    if (runtime && *runtime == '/' && isDirectory(runtime, 1)) {
        snprintf(parent, sizeof parent, "%s", runtime);
    } else if (cache && *cache == '/') {
        snprintf(parent, sizeof parent, "%s/steward", cache);
    } else if (user && *user == '/') {
        snprintf(parent, sizeof parent, "%s/.cache", user);
        mkdir(parent, 0700);
        strncat(parent, "/steward", sizeof parent - strlen(parent) - 1);
    } else {
        return 0;
    }
    mkdir(parent, 0700);
    length = snprintf(folder, sizeof folder, "%s/steward-resident", parent);
    if (length >= (int) sizeof folder || (mkdir(folder, 0700) && errno != EEXIST) || !isDirectory(folder, 1)) {
        return 0;
    }
    return snprintf(address.sun_path, sizeof address.sun_path, "%s/%016llx%016llx", folder,
        (unsigned long long) (digest >> 64), (unsigned long long) digest) < (int) sizeof address.sun_path;
}

/* Returns a connection to a resident of this user, or -1. */
static int connected(const struct sockaddr_un *to, pid_t *pid) {
    int found = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    struct ucred peer;
    socklen_t size = sizeof peer;
    if (found >= 0 && !connect(found, (const struct sockaddr *) to, sizeof *to)
            && !getsockopt(found, SOL_SOCKET, SO_PEERCRED, &peer, &size) && peer.uid == geteuid()) {
        *pid = peer.pid;
        return found;
    }
    int problem = errno;
    close(found);
    errno = problem;
    return -1;
}

/* True if this user may have one more resident. Removes the sockets that residents left which were killed. */
static int oneMore(void) {
    int count = 0;
    DIR *sockets = opendir(folder);
    for (struct dirent *each; sockets && (each = readdir(sockets));) {
        struct sockaddr_un other = {.sun_family = AF_UNIX};
        pid_t pid;
        if (strlen(each->d_name) != 32) {
            continue;
        }
        snprintf(other.sun_path, sizeof other.sun_path, "%s/%.32s", folder, each->d_name);
        int found = connected(&other, &pid);
        if (found < 0 && errno == ECONNREFUSED) {
            unlink(other.sun_path);
        } else {
            close(found);
            count++;
        }
    }
    if (sockets) {
        closedir(sockets);
    }
    return count < MOST_RESIDENTS;
}

/* Starts a resident and waits until it serves: it then says so on its standard output. */
static void startResident(const char *launcher) {
    int said[2];
    if (pipe2(said, O_CLOEXEC)) {
        return;
    }
    if (!fork()) {
        int nothing = open("/dev/null", O_RDWR);
        setsid();
        dup2(nothing, 0);
        dup2(said[1], 1);
        dup2(nothing, 2);
        syscall(SYS_close_range, 3, ~0U, 0);
        execl(launcher, launcher, "resident", "--socket", address.sun_path, (char *) NULL);
        _exit(127);
    }
    close(said[1]);
    struct pollfd word = {.fd = said[0], .events = POLLIN};
    poll(&word, 1, BOOT_MS);
    close(said[0]);
}

/* Returns a connection to the resident, which is started if it is not there; or -1. */
static int resident(const char *launcher) {
    pid_t pid;
    int found = connected(&address, &pid);
    if (found >= 0) {
        return found;
    }
    char path[sizeof folder + 8];
    snprintf(path, sizeof path, "%s/lock", folder);
    int lock = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock < 0 || flock(lock, LOCK_EX)) {
        return -1;
    }
    found = connected(&address, &pid);                  /* started by another client meanwhile */
    if (found < 0 && oneMore()) {
        startResident(launcher);
        found = connected(&address, &pid);
    }
    close(lock);
    return found;
}

/* ---- one command -------------------------------------------------------------------------------------------------- */

static int writeAll(int to, const char *bytes, size_t count) {
    while (count) {
        ssize_t written = to > 2 ? send(to, bytes, count, MSG_NOSIGNAL) : write(to, bytes, count);
        if (written < 0 && errno == EAGAIN) {           /* a stream of others that does not block */
            poll(&(struct pollfd) {.fd = to, .events = POLLOUT}, 1, -1);
        } else if (written < 0 && errno != EINTR) {
            return 0;
        }
        bytes += written > 0 ? written : 0;
        count -= written > 0 ? (size_t) written : 0;
    }
    return 1;
}

static int readAll(int from, char *bytes, size_t count) {
    while (count) {
        ssize_t found = read(from, bytes, count);
        if (found == 0 || (found < 0 && errno != EINTR)) {
            return 0;
        }
        bytes += found > 0 ? found : 0;
        count -= found > 0 ? (size_t) found : 0;
    }
    return 1;
}

static int sendFrame(int to, char type, const char *bytes, size_t count) {
    char frame[5 + MOST_BYTES] = {type, (char) (count >> 24), (char) (count >> 16), (char) (count >> 8), (char) count};
    if (count > MOST_BYTES) {
        return 0;
    }
    memcpy(frame + 5, bytes, count);
    return writeAll(to, frame, 5 + count);
}

/* Hands the call over. Returns 0 if it is too long. */
static int sendCall(int to, const char *command) {
    char call[MOST_BYTES];
    size_t length = 3;
    for (int stream = 0; stream < 3; stream++) {
        call[stream] = isatty(stream) ? '1' : '0';
    }
    for (const char *word = command, *const *next = (const char *const *) words; word; word = *next++) {
        size_t count = strlen(word) + 1;
        if (length + count > sizeof call) {
            return 0;
        }
        memcpy(call + length, word, count);
        length += count;
    }
    return sendFrame(to, 'A', call, length);
}

/* Sends what the input has now. Returns 0 if another has read it first. */
static int sendInput(int to) {
    static char input[MOST_BYTES];
    ssize_t count = read(0, input, sizeof input);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) {
        return 0;
    }
    const char *problem = count < 0 ? strerror(errno) : NULL;
    sendFrame(to, problem ? 'x' : 'i', problem ? problem : input, problem ? strlen(problem) : (size_t) count);
    return 1;
}

/* A tool takes a match without scores for a draw: each bot that the call names gets -1. */
static void printFailures(const char *command) {
    for (char **word = words; !strcmp(command, "referee") && *word; word++) {
        if (!strncmp(*word, "-p", 2) && (*word)[2] >= '1' && (*word)[2] <= '8' && (!(*word)[3] || (*word)[3] == '=')) {
            puts("-1");
        }
    }
    fflush(stdout);
}

/* Is the command until it is over. Returns its status, or -1 if the resident was lost and nothing has happened yet. */
static int beCommand(int to, const char *command) {
    static char bytes[MOST_BYTES];
    int touched = 0, printed = 0, ended = 0;           /* a stream was used, the output was; the signal that ends it */
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGHUP);
    sigprocmask(SIG_BLOCK, &signals, NULL);
    signal(SIGPIPE, SIG_IGN);
    struct pollfd each[] = {{.fd = to, .events = POLLIN},
        {.fd = signalfd(-1, &signals, SFD_CLOEXEC), .events = POLLIN}, {.fd = -1, .events = POLLIN}};
    for (;;) {
        unsigned char head[5];
        if (poll(each, 3, -1) < 0) {
            continue;
        }
        if (each[1].revents) {
            struct signalfd_siginfo signal;
            if (read(each[1].fd, &signal, sizeof signal) == sizeof signal) {
                char number = (char) signal.ssi_signo;
                if (ended || !sendFrame(to, 's', &number, 1)) {
                    return 128 + number;
                }
                ended = number;
            }
        }
        if (each[2].fd >= 0 && each[2].revents) {
            touched = 1;
            each[2].fd = sendInput(to) ? -1 : 0;
        }
        if (!each[0].revents) {
            continue;
        }
        uint32_t count = 0;
        if (readAll(to, (char *) head, sizeof head)) {
            count = (uint32_t) head[1] << 24 | (uint32_t) head[2] << 16 | (uint32_t) head[3] << 8 | head[4];
        } else {
            head[0] = 0;
        }
        if (count > sizeof bytes || !readAll(to, bytes, count)) {
            head[0] = 0;
        }
        switch (head[0]) {
            case 'O':
            case 'E': {
                const char *problem = writeAll(head[0] == 'O' ? 1 : 2, bytes, count) ? "" : strerror(errno);
                touched = 1;
                printed |= head[0] == 'O';
                sendFrame(to, 'o', problem, strlen(problem));
                break;
            }
            case 'I':
                each[2].fd = 0;
                break;
            case 'X':
                return (unsigned char) bytes[0];
            default:
                if (ended) {
                    return 128 + ended;
                }
                if (!touched) {
                    sigprocmask(SIG_UNBLOCK, &signals, NULL);
                    signal(SIGPIPE, SIG_DFL);
                    return -1;
                }
                if (!printed) {
                    printFailures(command);
                }
                fprintf(stderr, "steward: the resident referee has ended before the match\n");
                return 1;
        }
    }
}

/* Keeps a standard stream that is closed for what it is: files of ours are not to get its number. */
static void keepStreams(void) {
    for (int stream = 0; stream < 3; stream++) {
        if (fcntl(stream, F_GETFD) < 0) {
            open("/dev/null", stream ? O_RDONLY : O_WRONLY);
        }
    }
}

int main(int count, char **arguments) {
    char launcher[PATH_MAX + 16];
    keepStreams();
    ssize_t length = readlink("/proc/self/exe", home, sizeof home - 1);
    char *name = length < 0 ? NULL : strrchr(home, '/'), *command = name ? strchr(name, '-') : NULL;
    if (!command) {
        fprintf(stderr, "steward: found no installation around this program, expected it in its folder bin\n");
        return 2;
    }
    command++;
    *name = 0;
    char *bin = strrchr(home, '/');
    *(bin ? bin : home) = 0;
    snprintf(launcher, sizeof launcher, "%s/bin/steward", home);
    words = arguments + 1;

    int known = getuid() == geteuid() && getgid() == getegid() && addPlace() && findFolder();
    if (!strcmp(command, "resident")) {
        pid_t pid = 0;
        if (!known || connected(&address, &pid) >= 0) {
            fprintf(stderr, known ? "steward: found a resident for this folder and environment already, process %d\n"
                : "steward: found no folder for the socket that is this user's alone, expected one in the cache\n", pid);
            return 2;
        }
        char **with = calloc((size_t) count + 4, sizeof *with);
        with[0] = launcher;
        with[1] = "resident";
        with[2] = "--socket";
        with[3] = address.sun_path;
        memcpy(with + 4, words + (count > 1), (size_t) (count - (count > 1)) * sizeof *with);
        execv(launcher, with);
    } else {
        int to = known ? resident(launcher) : -1;
        int status = to >= 0 && sendCall(to, command) ? beCommand(to, command) : -1;
        if (status >= 0) {
            return status;
        }
        close(to);
        char **with = calloc((size_t) count + 2, sizeof *with);
        with[0] = launcher;
        with[1] = command;
        memcpy(with + 2, words, (size_t) count * sizeof *with);
        execv(launcher, with);
    }
    fprintf(stderr, "steward: %s cannot be started: %s\n", launcher, strerror(errno));
    return 2;
}
