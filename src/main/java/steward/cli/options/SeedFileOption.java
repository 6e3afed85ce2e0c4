package steward.cli.options;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;
import steward.contest.Contest;
import steward.contest.seeds.SeedFile;
import steward.contest.seeds.Seeds;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.BotIdentity;
import steward.league.ChosenSeeds;
import steward.league.LeagueFolder;
import steward.text.TextFormat;

/** Option for a list of seeds. It refuses a test of a bot whose own games were used to choose the seeds. */
public final class SeedFileOption {

    /** The option's name. */
    public static final String NAME = "--seed-file";

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = NAME, paramLabel = "FILE", description = "Plays the seeds of this file instead of consecutive "
        + "numbers: one a line; # begins a comment. 'steward seeds' can choose them.")
    private String file;

    @Option(names = "--anyway", description = "Plays even if games of one of the bots were used to choose the "
        + "seeds, counts its stored games on them, and flags the result.")
    private boolean anyway;

    private SeedFile read;

    /** True if there is a list. */
    public boolean isGiven() {
        return file != null;
    }

    /**
     * Refuses options that do not go together.
     *
     * @param seed   whether a first seed is named, too
     * @param stored whether there may be a list without the option: one that was stored earlier
     */
    public void check(boolean seed, boolean stored) {
        check.exclusive("--seed", seed, NAME, isGiven());
        check.that(!anyway || isGiven() || stored, "--anyway: expected " + NAME + " with it");
    }

    /** True if bots play on seeds that their own games chose, and the result is flagged. */
    public boolean isAnyway() {
        return anyway;
    }

    /** Keeps the list in a league that gets its games, see {@link ChosenSeeds}. */
    public void keepIn(Path league) {
        ChosenSeeds.keep(LeagueFolder.open(league), read());
    }

    /** Returns the file; {@code null} if there is none. */
    public SeedFile read() {
        read = read == null && file != null ? SeedFile.read(OutputFiles.path(file)) : read;
        return read;
    }

    /** Returns the seeds of the file. */
    public Seeds seeds() {
        return read().seeds();
    }

    /** Refuses a file with fewer seeds. @param why ends the refusal, such as ", one for each game" */
    public void atLeast(long count, String why) {
        if (seeds().count() < count) {
            throw new InputException(read().source() + ": found " + TextFormat.count(seeds().count(), "seed")
                + ", expected at least " + count + why);
        }
    }

    /**
     * Names of the bots by whose games the seeds were chosen; none without a file.
     *
     * @throws InputException if there is one, and nobody wants it anyway
     */
    public List<String> choosers(List<Contest.Entrant> bots) {
        return choosers(read(), bots);
    }

    /** As {@link #choosers(List)}, of another list than that of the option. @param list {@code null} for none */
    public List<String> choosers(SeedFile list, List<Contest.Entrant> bots) {
        if (list == null) {
            return List.of();
        }
        List<String> found = choosers(list.choosers(), bots);
        if (!found.isEmpty() && !anyway) {
            throw new InputException(list.source() + ": found seeds that were chosen by games of "
                + TextFormat.plain(String.join(" and ", found)) + ", expected others: such seeds tell of a bot what "
                + "its own games told; --anyway plays on them and flags the result");
        }
        return found;
    }

    /** Names of the bots that are among those that chose. @param choosers by identity */
    public static List<String> choosers(Map<String, String> choosers, List<Contest.Entrant> bots) {
        return choosers.isEmpty() ? List.of() : bots.stream()
            .filter(bot -> choosers.containsKey(BotIdentity.ofProgram(bot))).map(Contest.Entrant::name).toList();
    }

    /** Returns a line that flags a result; {@code null} where no bot chose the seeds. */
    public static String flag(List<String> choosers) {
        return choosers.isEmpty() ? null : "Flagged: the seeds were chosen by games of "
            + TextFormat.plain(String.join(" and ", choosers)) + "; the result is of these seeds alone.";
    }
}
