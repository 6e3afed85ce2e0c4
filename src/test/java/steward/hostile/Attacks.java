package steward.hostile;

import static steward.hostile.Attack.Effect.ESCAPES;
import static steward.hostile.Attack.Effect.SUCCEEDS;

import java.util.List;

/** All attacks of the suite, in the order of the table in {@code docs/tables/attacks.md}. */
final class Attacks {

    static final String NONE = "none";
    private static final String LATE = "no answer within .*";
    private static final String BAD = "bad answer.*|.*found.*|.*expected.*|.*not JSON.*";
    private static final String SH = "sh";
    private static final String C = "c";

    static final List<Attack> ALL = List.of(
        Attack.held("exits with status 0", SH, "exit-0", "exited with status 0 before answering").often(),
        Attack.held("exits with status 3", SH, "exit-3", "exited with status 3 before answering"),
        Attack.held("exits with status 255", SH, "exit-255", "exited with status 255 before answering"),
        Attack.held("ends itself by SIGSEGV", SH, "signal-SEGV", "killed by signal 11 \\(SIGSEGV\\) before answering"),
        Attack.held("ends itself by SIGKILL", SH, "signal-KILL", "killed by signal 9 \\(SIGKILL\\) before answering")
            .often(),
        Attack.held("ends itself by SIGTERM", SH, "signal-TERM", "killed by signal 15 \\(SIGTERM\\) before answering"),
        Attack.held("ends itself by SIGPIPE", SH, "signal-PIPE", "killed by signal 13 \\(SIGPIPE\\) before answering"),
        Attack.held("writes to address 0", C, "crash", "killed by signal 11 \\(SIGSEGV\\) before answering"),
        Attack.held("kills its group", SH, "kill-group", "killed by signal 9 \\(SIGKILL\\) before answering").often(),
        Attack.held("stops itself", SH, "stop", LATE).inTime(),
        Attack.held("never answers", SH, "silent-start", LATE).inTime(),
        Attack.held("loops for ever", SH, "loop", LATE).inTime().often(),
        Attack.held("blocks and ignores every signal", C, "blocks-signals", LATE).inTime(),
        Attack.held("answers later by a fifth of a millisecond each turn", C, "late", LATE).inTime(),
        Attack.held("answers half a line", SH, "half", LATE).inTime(),
        Attack.held("answers twice", SH, "doubled", NONE),
        Attack.held("answers 5,000 times", SH, "flooded", NONE).often(),
        Attack.held("answers before the question", SH, "early", NONE),
        Attack.held("writes without end and without a line end", SH, "long-line", "line longer than 65536 bytes")
            .often(),
        Attack.held("answers NUL bytes", SH, "nul", BAD),
        Attack.held("answers an empty line", SH, "empty", BAD),
        Attack.held("answers bytes that are not UTF-8", SH, "bad-utf8", BAD),
        Attack.held("answers 30,000 nested arrays", SH, "deep", BAD).often(),
        Attack.held("answers with a field twice", SH, "duplicate", BAD),
        Attack.held("answers a number that is infinite", SH, "huge-number", BAD),
        Attack.held("answers a thrust of 2^31", SH, "thrust", BAD),
        Attack.held("answers NaN", SH, "nan", BAD),
        Attack.held("writes 50 MB to stderr", SH, "stderr-flood", NONE).often(),
        Attack.held("closes its input", SH, "no-stdin", LATE + "|did not read its input .*").inTime(),
        Attack.held("closes its output", SH, "no-stdout", "closed its output before answering"),
        Attack.held("has 20 children", SH, "children", NONE).often(),
        Attack.held("leaves a child behind and exits", SH, "children-exit", "exited with status 5 before answering"),
        Attack.held("has a child that ignores signals", SH, "deaf-children", NONE),
        Attack.held("starts a process in a session of its own", SH, "leaves", NONE).off(ESCAPES).often(),
        Attack.held("leaves one behind that holds its output, and exits", SH, "holds-stdout",
            "exited with status 6 before answering").off(ESCAPES),
        Attack.held("leaves one behind that writes to stderr", SH, "fills-stderr", NONE).often(),
        Attack.held("forks twice in a session of its own", C, "double-fork", NONE).off(ESCAPES).often(),
        Attack.held("forks 50 times in a row", C, "chain", NONE).often(),
        Attack.held("forks 50 times in a row, a session each", C, "chain-sessions", NONE).off(ESCAPES),
        Attack.held("clears the signal of its parent's death", C, "no-death-signal", NONE).off(ESCAPES),
        Attack.held("starts a process in namespaces of its own", C, "nested-namespace", NONE).off(ESCAPES),
        Attack.held("takes 300 MB of memory", C, "memory", NONE).slow(),
        Attack.held("fills 300 MB of files in memory with `--memory 64M`", C, "memory-files",
            "none|used \\d+ MiB of memory, expected at most 64 MiB").slow().limitedMemory().often(),
        Attack.held("opens 3,000 files", C, "descriptors", NONE),
        Attack.held("computes on four threads all the time", C, "threads", NONE),
        Attack.held("has four children that compute all the time", SH, "hogs", NONE),
        Attack.held("fills 80 MB of the disk", SH, "fills-disk", NONE),
        Attack.held("reads its opponent's environment and pipes", SH, "reads-opponent", NONE).off(SUCCEEDS),
        Attack.held("answers in its opponent's place", SH, "forges", NONE).off(SUCCEEDS).often(),
        Attack.held("reads its opponent's memory", C, "reads-memory", NONE).off(SUCCEEDS),
        Attack.held("traces its opponent", C, "traces", NONE).off(SUCCEEDS),
        Attack.held("stops its opponent", SH, "stops-opponent", NONE).off(SUCCEEDS),
        Attack.held("kills its opponent", SH, "kills-opponent", NONE).off(SUCCEEDS).often(),
        Attack.held("sets limits of the first process of its namespace", C, "first-process",
            NONE).often(),
        Attack.held("leaves a key for others in the session", C, "keys", NONE).off(SUCCEEDS).often(),
        Attack.held("makes system calls that no bot needs", C,
            "calls", NONE).often(),
        Attack.held("opens settings of the kernel for writing", C, "kernel-settings", NONE).often(),
        Attack.held("unmounts its `/proc` to see the processes of the machine", SH, "unmounts", NONE),
        Attack.held("kills the referee", SH, "kills-referee", NONE).off(SUCCEEDS).onReferee().often(),
        Attack.held("asks the referee to end", SH, "terminates-referee", NONE).off(SUCCEEDS).onReferee(),
        Attack.held("stops the referee for a while", SH, "stops-referee", NONE).onReferee(),
        Attack.held("kills the sentinel", SH, "kills-sentinel", NONE).onReferee(),
        Attack.held("kills the sentinel and the referee", SH, "kills-both", NONE).off(ESCAPES).onReferee(),
        Attack.held("writes to the replay through the referee's `/proc`", SH, "changes-replay", NONE).off(SUCCEEDS)
            .onReferee());

    private Attacks() {
    }
}
