package steward.machines.check;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * Statistics of bots that were asked again, by bot and worker, which raise suspicion of a worker. If a bot answers
 * differently each time, it depends on the clock; if it fails here, it fails here. Both are facts about the bot, which
 * is not asked again. If a bot gives one answer here, twice, and another on a worker, either the bot depends on the
 * machine or the worker made the answer up. When that is too frequent for chance, the worker is suspected and an
 * operator decides. Thread-safe.
 */
public final class AskedAgain {

    /** Games with another answer before they are looked at; then after each doubling. */
    private static final int FIRST = 5;

    private final Consumer<String> teller;
    private final Suspecter suspecter;
    /** By bot and worker: games in which the bot was asked again, and those in which it answered otherwise. */
    private final Map<String, Map<String, int[]>> counts = new HashMap<>();
    private final Set<String> settled = new HashSet<>();
    private final Map<String, Map<String, String>> doubts = new HashMap<>();

    /** Takes doubts about a worker, by any thread. */
    public interface Suspecter {
        void suspect(String worker, String doubt) throws InterruptedException;
    }

    /** @param teller is told what is found, by any thread */
    public AskedAgain(Consumer<String> teller, Suspecter suspecter) {
        this.teller = teller;
        this.suspecter = suspecter;
    }

    /**
     * Asks a bot, a second time if it answers otherwise.
     *
     * @param worker whose game it is
     * @param ask    asks it once; {@code null} if all answers are the recorded ones
     */
    public void ask(String bot, String worker, Supplier<AnswerCheck.Otherwise> ask) throws InterruptedException {
        synchronized (this) {
            if (settled.contains(bot)) {
                return;
            }
        }
        AnswerCheck.Otherwise found = ask.get();
        if (found == null) {
            count(bot, worker, null);
        } else if (found.failsHere()) {
            settle(bot, bot + " fails on the league's machine, and does not on worker " + worker + ": "
                + found.text());
        } else if (!found.equals(ask.get())) {
            settle(bot, bot + " plays by the clock: each time it is asked it answers otherwise: " + found.text());
        } else {
            count(bot, worker, found.text());
        }
    }

    private void settle(String bot, String what) {
        boolean isNew;
        synchronized (this) {
            isNew = settled.add(bot);
            doubts.values().forEach(each -> each.remove(bot));
        }
        if (isNew) {
            teller.accept(what + "; it is not asked again in this run");
        }
    }

    private void count(String bot, String worker, String otherwise) throws InterruptedException {
        String doubt;
        synchronized (this) {
            Map<String, int[]> workers = counts.computeIfAbsent(bot, any -> new TreeMap<>());
            int[] own = workers.computeIfAbsent(worker, any -> new int[2]);
            own[0]++;
            own[1] += otherwise == null ? 0 : 1;
            doubt = otherwise == null || settled.contains(bot) ? null : doubt(bot, workers, own, otherwise);
            if (doubt == null) {
                return;
            }
            doubts.computeIfAbsent(worker, any -> new TreeMap<>()).put(bot, doubt);
        }
        teller.accept("worker " + worker + " is doubtful: " + doubt);
        suspecter.suspect(worker, doubt);
    }

    /** Compares a worker with all others at {@link #FIRST} games, then at twice as many, at a level that halves. */
    private static String doubt(String bot, Map<String, int[]> workers, int[] own, String otherwise) {
        int looks = own[1] % FIRST == 0 ? own[1] / FIRST : 0;
        if (looks == 0 || Integer.bitCount(looks) != 1) {
            return null;
        }
        int all = workers.values().stream().mapToInt(each -> each[0]).sum();
        int marked = workers.values().stream().mapToInt(each -> each[1]).sum();
        String text = bot + " answered otherwise than here in " + own[1] + " of " + own[0] + " games that were asked "
            + "again, here the same twice";
        if (all == own[0]) {
            return text + " (no other worker to compare with), such as " + otherwise;
        }
        DrawnWithout test = new DrawnWithout();
        test.add(all, marked, own[0], own[1]);
        double chance = test.chance();
        return chance > WorkerBook.LEVEL / (2 * looks) || own[1] < test.mean() ? null
            : text + ", elsewhere in " + (marked - own[1]) + " of " + (all - own[0])
            + String.format(Locale.ROOT, " (p = %.1e)", chance) + ", such as " + otherwise;
    }

    /** Doubts about a worker, a sentence for each bot. */
    public synchronized List<String> doubts(String worker) {
        return new ArrayList<>(doubts.getOrDefault(worker, Map.of()).values());
    }
}
