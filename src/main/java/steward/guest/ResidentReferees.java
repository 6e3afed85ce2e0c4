package steward.guest;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import steward.bot.isolation.Isolation;

/** Pool of idle referee JVMs, each of which can play the next game of the same referee. */
final class ResidentReferees {

    private static final ResidentReferees SHARED = new ResidentReferees();
    private static final int MOST = Math.max(2, Runtime.getRuntime().availableProcessors());

    private final Deque<RefereeProcess> idle = new ArrayDeque<>();

    static ResidentReferees shared() {
        return SHARED;
    }

    /** A referee that plays one game, to be closed or given back. */
    RefereeProcess take(List<String> command, Isolation isolation, int limitMs) {
        synchronized (idle) {
            for (RefereeProcess each : idle) {
                if (each.isOf(command, isolation)) {
                    idle.remove(each);
                    each.limit(limitMs);
                    return each;
                }
            }
        }
        return RefereeProcess.start(command, isolation, limitMs);
    }

    /** Takes a referee back whose game is over. If it is full, or others are idle already, one is ended. */
    void giveBack(RefereeProcess process) {
        List<RefereeBlock> answer;
        try {
            answer = process.exchange(RefereeBlock.text("END", List.of()));
        } catch (RefereeFault late) {
            return;                                  // it is ended; the game was over, and its result counts
        }
        if (!answer.get(answer.size() - 1).lines().equals(List.of("go on"))) {
            process.close();
            return;
        }
        process.forgetStderr();
        RefereeProcess ended;
        synchronized (idle) {
            idle.addFirst(process);
            ended = idle.size() > MOST ? idle.removeLast() : null;
        }
        if (ended != null) {
            ended.close();
        }
    }

    /** Ends all that are idle. */
    void close() {
        synchronized (idle) {
            idle.forEach(RefereeProcess::close);
            idle.clear();
        }
    }
}
