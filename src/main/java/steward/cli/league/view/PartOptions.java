package steward.cli.league.view;

import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Option;
import steward.cli.options.CallCheck;
import steward.files.InputException;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.text.NearestName;

/** Options that restrict a table to part of the games. */
final class PartOptions {

    private static final Pattern AGE = Pattern.compile("([0-9]{1,6})([hd])");
    private static final Pattern SEEDS = Pattern.compile("(-?[0-9]{1,19})\\.\\.(-?[0-9]{1,19})");

    private final CallCheck check = CallCheck.withHelp();

    @Option(names = "--bots", paramLabel = "NAMES", split = ",", description = "Only games between these bots, "
        + "separated by commas; NAME is all versions, NAME#2 the second.")
    private List<String> bots = new ArrayList<>();

    @Option(names = "--without", paramLabel = "NAMES", split = ",", description = "Only games without these bots.")
    private List<String> without = new ArrayList<>();

    @Option(names = "--since", paramLabel = "WHEN", description = "Only games that ended since then: an age "
        + "such as 12h or 30d, a day such as 2026-11-23 (UTC), or a time such as 2026-11-23T18:00:00Z.")
    private String since;

    @Option(names = "--last", paramLabel = "N", description = "Only the last N of the games that count.")
    private Integer last;

    @Option(names = "--seeds", paramLabel = "A..B", description = "Only games with these seeds.")
    private String seeds;

    /** True if any of them is there. */
    boolean isAny() {
        return !bots.isEmpty() || !without.isEmpty() || since != null || last != null || seeds != null;
    }

    /** Refuses values that cannot be. */
    void check() {
        check.range("--last", last, 1, Integer.MAX_VALUE);
        since(0);
        seeds();
    }

    /**
     * The games that are meant.
     *
     * @throws InputException if there are none, or a bot is not known
     */
    void each(LeagueOpening.Opened opened, Consumer<StoredGame> taker) {
        Set<Integer> among = versions("--bots", bots, opened.entries());
        Set<Integer> not = versions("--without", without, opened.entries());
        long from = since(System.currentTimeMillis());
        long[] range = seeds();
        List<StoredGame> found = new ArrayList<>();
        opened.games().games(game -> {
            boolean fits = game.counts() && game.played() >= from && game.seed() >= range[0] && game.seed() <= range[1]
                && Arrays.stream(game.lineup()).allMatch(version -> (bots.isEmpty() || among.contains(version))
                && !not.contains(version));
            if (fits) {
                found.add(game);
            }
        });
        if (found.isEmpty()) {
            throw new InputException("found no game in this part of the league, expected one at least");
        }
        found.subList(last == null ? 0 : Math.max(0, found.size() - last), found.size()).forEach(taker);
    }

    /** The bots that can have a row. */
    List<LeagueTable.Entry> rows(List<LeagueTable.Entry> entries) {
        Set<Integer> among = versions("--bots", bots, entries);
        Set<Integer> not = versions("--without", without, entries);
        return entries.stream().filter(entry -> (bots.isEmpty() || among.contains(entry.version()))
            && !not.contains(entry.version())).toList();
    }

    private static Set<Integer> versions(String option, List<String> wanted, List<LeagueTable.Entry> entries) {
        Set<Integer> versions = new HashSet<>();
        for (String name : wanted) {
            List<LeagueTable.Entry> found = entries.stream().filter(entry -> entry.name().equals(name)
                || !name.contains("#") && entry.name().startsWith(name + "#")).toList();
            List<String> names = entries.stream().map(LeagueTable.Entry::name).toList();
            if (found.isEmpty()) {
                throw new InputException(option + ": found no bot '" + name + "' with games, expected one of "
                    + String.join(", ", names) + NearestName.question(name, names, "'"));
            }
            found.forEach(entry -> versions.add(entry.version()));
        }
        return versions;
    }

    private long since(long now) {
        if (since == null) {
            return Long.MIN_VALUE;
        }
        Matcher age = AGE.matcher(since);
        if (age.matches()) {
            return now - (age.group(2).equals("h") ? TimeUnit.HOURS : TimeUnit.DAYS)
                .toMillis(Long.parseLong(age.group(1)));
        }
        try {
            return since.contains("T") ? Instant.parse(since).toEpochMilli()
                : LocalDate.parse(since).atStartOfDay(ZoneOffset.UTC).toInstant().toEpochMilli();
        } catch (DateTimeParseException problem) {
            check.that(false, "--since: found '" + since + "', expected an age such as 12h or 30d, or a day such as "
                + "2026-11-23");
            return 0;
        }
    }

    private long[] seeds() {
        if (seeds == null) {
            return new long[] {Long.MIN_VALUE, Long.MAX_VALUE};
        }
        Matcher range = SEEDS.matcher(seeds);
        try {
            long[] found = range.matches() ? new long[] {Long.parseLong(range.group(1)), Long.parseLong(range.group(2))}
                : new long[] {1, 0};
            check.that(found[0] <= found[1], "--seeds: found '" + seeds + "', expected two seeds such as 1..100, the "
                + "lower one first");
            return found;
        } catch (NumberFormatException tooLong) {
            check.that(false, "--seeds: found '" + seeds + "', expected two whole numbers of 64 bits such as 1..100");
            return new long[2];
        }
    }
}
