package steward.league.play;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.bot.command.Program;
import steward.contest.ProgramWatch;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.play.Roster.Member;
import steward.scene.json.SceneException;
import steward.text.TextFormat;

/**
 * Watch over league.json and the files of the bots while a league is played. If an edit cannot be used, that is
 * reported and the earlier settings stay in force. Not thread-safe.
 */
final class RosterWatch {

    /** How often files are looked at, in milliseconds. */
    private static final long LOOK_MS = 200;

    private final LeagueFolder folder;
    private final RosterReader reader;
    private final Consumer<String> teller;
    private String seen;
    private long looked = System.nanoTime();
    private ProgramWatch programs;
    private boolean paused;
    private String told = "";

    /** @param teller is told what has been read anew, and what cannot be used */
    RosterWatch(LeagueFolder folder, RosterReader reader, LeagueSettings settings, Consumer<String> teller) {
        this.folder = folder;
        this.reader = reader;
        this.teller = teller;
        seen = Program.stamp(folder.settings());
        programs = RosterReader.watch(settings, this::tell);
    }

    /** True if the file of a bot is being changed or cannot be used: no game is to be begun then. */
    boolean isPaused() {
        return paused;
    }

    /** True if a file of one of these bots has changed since they were read. */
    boolean isChanged(List<Member> members) {
        return members.stream().anyMatch(member -> !reader.stamp(member.bot()).equals(member.stamp()));
    }

    /** The next look is not to wait. */
    void lookSoon() {
        looked = System.nanoTime() - TimeUnit.MILLISECONDS.toNanos(LOOK_MS);
    }

    /**
     * Looks whether league.json or the file of a bot has changed, if the last look is long enough ago.
     *
     * @param roster in force
     * @param learns whether the run may change to a pairing that uses results
     * @param user   takes a roster that was read anew; may refuse it by an {@link InputException}
     */
    void look(Roster roster, boolean learns, Consumer<Roster> user) {
        if (System.nanoTime() - looked < TimeUnit.MILLISECONDS.toNanos(LOOK_MS)) {
            return;
        }
        looked = System.nanoTime();
        ProgramWatch.State state = programs.look();
        boolean changed = state != ProgramWatch.State.SAME || isChanged(roster.members());
        String now = Program.stamp(folder.settings());
        boolean edited = !now.equals(seen);
        if (!edited && !changed) {
            paused = false;
            return;
        }
        if (state == ProgramWatch.State.WAITING && (!edited || programs.waitsFor() == null)) {
            paused = true;
            return;
        }
        try {
            LeagueSettings read = edited ? folder.read() : roster.settings();
            String fixed = fixed(roster.settings(), read, learns);
            if (fixed != null) {
                throw new InputException(folder.settings() + ": " + fixed
                    + " has changed, which is read when a run begins");
            }
            if (state == ProgramWatch.State.WAITING && read.active().stream().anyMatch(bot ->
                    bot.name().equals(programs.waitsFor()))) {
                paused = true;
                return;
            }
            ProgramWatch anew = RosterReader.watch(read, this::tell);
            Roster next = folder.named(() -> reader.read(read));
            user.accept(next);
            programs = anew;
            paused = false;
            tell(edited ? "read " + folder.settings() + " anew: " + TextFormat.count(next.members().size(), "bot")
                : "");
        } catch (SceneException | InputException problem) {
            paused = changed;
            tell(problem.getMessage() + (changed ? "; no game is begun until that is so"
                : "; the league goes on as before"));
        }
        seen = now;
    }

    /** Says something, once. */
    private void tell(String what) {
        if (!what.isEmpty() && !what.equals(told)) {
            teller.accept(what);
        }
        told = what;
    }

    private static String fixed(LeagueSettings old, LeagueSettings read, boolean learns) {
        return !read.scene().equals(old.scene()) ? "the scene"
            : !read.limits().equals(old.limits()) ? "the time limit"
            : !read.sandbox().equals(old.sandbox()) ? "the sandbox"
            : read.adaptive() && !old.adaptive() && !learns ? "the pairing"
            : read.seed() != old.seed() ? "the seed"
            : !Objects.equals(read.seedFile(), old.seedFile()) ? "the list of seeds"
            : read.lag() != old.lag() ? "the lag" : null;
    }
}
