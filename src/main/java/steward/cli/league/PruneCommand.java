package steward.cli.league;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.league.view.LeagueArgument;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.league.LeagueFolder;
import steward.league.StoredGame;
import steward.text.TextFormat;

/** {@code steward league prune}: removes replays. */
@Command(name = "prune", description = "Removes kept replays of a league; the games stay.",
    footer = {
        "", "Files in the folder of replays that belong to no game, as 'kill -9' may leave",
        "them, are also removed if they are older than a day.",
        "", "Examples:",
        "  steward league prune night --keep lost --older 30d",
        "  steward league prune night --keep none --dry-run"})
final class PruneCommand extends ProgramCommand {

    private static final Pattern AGE = Pattern.compile("([0-9]{1,6})([hd])");
    private static final long A_DAY_MS = TimeUnit.DAYS.toMillis(1);

    @Mixin
    private final LeagueArgument league = new LeagueArgument();

    @Option(names = "--keep", required = true, paramLabel = "lost|none",
        description = "Keeps the replays of games that have a loser (lost), or none at all.")
    private String keep;

    @Option(names = "--bot", paramLabel = "NAME", description = "With --keep lost: only of games that this bot lost; "
        + "can be repeated.")
    private List<String> bots = new ArrayList<>();

    @Option(names = "--older", paramLabel = "AGE", description = "Removes only replays that are older, such as 12h or "
        + "30d.")
    private String older;

    @Option(names = "--dry-run", description = "Says what would be removed, and removes nothing.")
    private boolean dry;

    /** Total of a prune. */
    private static final class Sum {
        private int files;
        private long bytes;

        private void add(Path file) throws IOException {
            if (Files.isRegularFile(file)) {
                files++;
                bytes += Files.size(file);
            }
        }

        private String text() {
            return TextFormat.count(files, "replay") + ", " + Sizes.text(bytes);
        }
    }

    @Override
    public Integer call() throws IOException {
        check.that(keep.equals("lost") || keep.equals("none"), "--keep: found '" + keep + "', expected lost or none");
        check.that(bots.isEmpty() || keep.equals("lost"), "--bot: expected --keep lost with it");
        long before = before();
        LeagueFolder folder = dry ? league.open() : league.openToWrite(streams);
        try (LeagueOpening.Opened opened = dry ? LeagueOpening.read(folder) : LeagueOpening.write(folder)) {
            bots.forEach(bot -> LeagueOpening.bot(opened.settings(), bot));
            Set<Integer> losers = new HashSet<>();
            opened.store().versions().stream().filter(version -> bots.contains(version.bot()))
                .forEach(version -> losers.add(version.id()));
            Sum kept = new Sum();
            Sum removed = new Sum();
            List<Long> games = new ArrayList<>();
            List<Path> files = new ArrayList<>();
            Set<Path> known = new HashSet<>();
            for (StoredGame game : opened.games().withReplay(Integer.MAX_VALUE)) {
                Path file = folder.replays().resolve(game.replay());
                known.add(file);
                boolean goes = game.played() < before && !(keep.equals("lost") && isLost(game, losers));
                (goes ? removed : kept).add(file);
                if (goes) {
                    games.add(game.id());
                    files.add(file);
                }
            }
            Sum strays = new Sum();
            for (Path stray : strays(folder, known, opened)) {
                strays.add(stray);
                files.add(stray);
            }
            if (!dry) {
                opened.store().withoutReplays(games);          // first: a replay that is named is there
                for (Path file : files) {
                    Files.deleteIfExists(file);
                }
            }
            streams.out().println((dry ? "Would remove: " : "Removed: ") + removed.text()
                + (strays.files > 0 ? "; of no game: " + strays.text() : "") + ". " + (dry ? "Would keep: " : "Kept: ")
                + kept.text() + ".");
        }
        return ExitStatus.DONE;
    }

    private long before() {
        if (older == null) {
            return Long.MAX_VALUE;
        }
        Matcher matcher = AGE.matcher(older);
        check.that(matcher.matches(), "--older: found '" + older + "', expected an age such as 12h or 30d");
        long count = Long.parseLong(matcher.group(1));
        return System.currentTimeMillis() - (matcher.group(2).equals("h") ? TimeUnit.HOURS : TimeUnit.DAYS)
            .toMillis(count);
    }

    private static boolean isLost(StoredGame game, Set<Integer> losers) {
        return game.counts() && game.seats().stream().anyMatch(seat -> seat.rank() > 0
            && (losers.isEmpty() || losers.contains(seat.version())));
    }

    /** Files that belong to no game of any season and are not just being written. */
    private static List<Path> strays(LeagueFolder folder, Set<Path> known, LeagueOpening.Opened opened)
            throws IOException {
        if (!Files.isDirectory(folder.replays())) {
            return List.of();
        }
        Set<String> named = opened.games().allReplays();
        List<Path> strays = new ArrayList<>();
        try (Stream<Path> files = Files.walk(folder.replays())) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                boolean old = Files.getLastModifiedTime(file).toMillis() < System.currentTimeMillis() - A_DAY_MS;
                boolean ours = file.toString().endsWith(".jsonl") || file.toString().endsWith(".part");
                if (old && ours && !known.contains(file)
                    && !named.contains(folder.replays().relativize(file).toString().replace('\\', '/'))) {
                    strays.add(file);
                }
            }
        }
        return strays;
    }
}
