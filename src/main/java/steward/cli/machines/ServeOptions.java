package steward.cli.machines;

import java.net.InetSocketAddress;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Option;
import steward.cli.league.run.LeagueRunCommand;
import steward.cli.league.run.Serving;
import steward.cli.options.CallCheck;
import steward.cli.options.OptionSection;
import steward.cli.shared.ProgramVersion;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.machines.serve.RemoteGames;

/** Options of {@code league run} that let workers play. */
@OptionSection("Workers")
public final class ServeOptions implements Serving {

    /** Where a league listens unless told otherwise: only programs of this machine can join. */
    static final String USUAL = "127.0.0.1:7161";
    private static final Pattern ADDRESS = Pattern.compile("(?:\\[([0-9A-Fa-f:]+)\\]|([^:\\[\\]]+)):([0-9]{1,5})");
    private static final int MOST_PORT = 65_535;

    @Option(names = "--serve", paramLabel = "HOST:PORT", arity = "0..1", fallbackValue = USUAL,
        description = "Lets workers play, too (see 'steward worker'; default: " + USUAL + "). For workers on "
            + "other machines, give an address of this machine, or 0.0.0.0 for all of its addresses.")
    private String address;

    @Option(names = "--again", paramLabel = "PERCENT", description = "With --serve: checks this share of a "
        + "worker's games, after its first 20, by asking the bots again (default: 5). 0 for none, not even the "
        + "first 20.")
    private Integer again;

    @Option(names = "--lease", paramLabel = "TIME", description = "With --serve: gives games that a worker has "
        + "kept for this time to others (default: 10m).")
    private String lease;

    @Option(names = "--scale-time", description = "With --serve: multiplies a worker's time limits by the "
        + "measured speed of this machine's processor divided by that of the worker's. It is noted with each game.")
    private boolean scaled;

    @Override
    public boolean isServed() {
        return address != null;
    }

    @Override
    public Service start(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings,
                         Consumer<String> teller) {
        CallCheck check = CallCheck.withHelp();
        check.that(again == null || address != null, "--again is for --serve, expected both");
        check.that(!scaled || address != null, "--scale-time is for --serve, expected both");
        check.that(lease == null || address != null, "--lease is for --serve, expected both");
        check.range("--again", again, 0, 100);
        long nanos = LeagueRunCommand.nanos("--lease", lease == null ? "10m" : lease);
        return address == null ? null : new ServedGames(folder, season, contest, settings,
            new RemoteGames.Service(address(check, "--serve", address), again == null ? 0.05 : again / 100.0, nanos,
                ProgramVersion.text(), scaled), teller);
    }

    /** An address as it was typed, its name looked up. */
    static InetSocketAddress address(CallCheck check, String option, String typed) {
        Matcher matcher = ADDRESS.matcher(typed);
        int port = matcher.matches() ? Integer.parseInt(matcher.group(3)) : 0;
        check.that(port > 0 && port <= MOST_PORT, option + ": found '" + typed + "', expected HOST:PORT, such as "
            + USUAL);
        return new InetSocketAddress(matcher.group(1) == null ? matcher.group(2) : matcher.group(1), port);
    }
}
