package steward.machines.part;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.cli.league.view.LeagueOpening;
import steward.cli.shared.Games;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.play.Roster;
import steward.league.play.RosterReader;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.league.store.PartStore;
import steward.league.store.SealedRows;
import steward.league.store.SeasonOpening;
import steward.machines.check.GzipText;
import steward.machines.check.TranscriptWriter;
import steward.match.Protocol;

/** Parts of leagues of shell bots, which are deterministic: played, merged, forged. */
@Tag("process")
@Tag("slow")
@Timeout(600)
class PartTest {

    private static final int GAMES = 12;

    @TempDir
    private Path folder;

    private TextShellBots bots;

    @BeforeEach
    void prepare() throws IOException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        ShellBots.shortDuel(folder);
        bots = new TextShellBots(folder);
    }

    private Cli league(String... words) {
        return Cli.league(folder, words);
    }

    private String done(String... words) {
        return league(words).done().out();
    }

    private void make(String name, String seed) throws IOException {
        done("init", "TMP/" + name, "--scene", "TMP/short.json", "--seed", seed);
        fix(name);
        done("add", "TMP/" + name, "fast=codingame:" + bots.driver());
        done("add", "TMP/" + name, "still=codingame:" + bots.idler(0));
        done("add", "TMP/" + name, "wrong=codingame:" + bots.idler(3));
    }

    /** Parts need a schedule that does not depend on results. */
    private void fix(String name) throws IOException {
        Path file = folder.resolve(name).resolve("league.json");
        String text = Files.readString(file);
        assertTrue(text.contains("\"adaptive\""), text);
        Files.writeString(file, text.replace("\"adaptive\"", "\"round-robin\""));
    }

    @Test
    void aScheduleThatDependsOnResultsCannotBePlayedInParts() {
        done("init", "TMP/adaptive", "--scene", "TMP/short.json", "--seed", "5");
        done("add", "TMP/adaptive", "fast=codingame:" + bots.driver());
        done("add", "TMP/adaptive", "still=codingame:" + bots.idler(0));
        league("shard", "TMP/adaptive", "--part", "1/3", "--games", "12", "--out", "TMP/part1.db")
            .assertRefused("pairing: found 'adaptive', which decides by results, expected 'round-robin'");
        assertTrue(Files.notExists(folder.resolve("part1.db")), "a part of it would be in the way of the right one");
    }

    private void shard(String league, int part, int parts) {
        done("shard", "TMP/" + league, "--part", part + "/" + parts, "--games", Integer.toString(GAMES), "--out",
            "TMP/part" + part + ".db");
    }

    /** Every game without what is measured: it has to be the same wherever it was played. */
    private List<String> games(String league) {
        List<String> lines = new ArrayList<>();
        try (GameStore store = GameStore.read(new LeagueFolder(folder.resolve(league)))) {
            Map<Integer, String> names = new HashMap<>();
            store.versions().forEach(version -> names.put(version.id(), version.display()));
            Season season = store.lastSeason().orElseThrow();
            new GameQueries(store, store.season(season).orElseThrow(), season).games(game ->
                lines.add(game.decision() + " " + game.seed() + " " + game.attempt() + " " + game.counts() + " "
                    + game.turns() + " " + game.seats().stream().map(seat -> names.get(seat.version()) + ":"
                        + seat.rank() + ":" + seat.score() + ":" + seat.fault() + ":" + seat.answers()).toList()));
        }
        lines.sort(null);
        return lines;
    }

    @Test
    void allPartsTogetherAreTheGamesOfOneMachine() throws IOException {
        make("whole", "5");
        done("run", "TMP/whole", "--games", Integer.toString(GAMES), "--quiet");
        make("parts", "5");
        for (int part = 1; part <= 3; part++) {
            shard("parts", part, 3);
        }
        assertTrue(done("merge", "TMP/parts", "TMP/part2.db").contains("part 2/3, 4 games stored"));
        assertTrue(done("merge", "TMP/parts", "TMP/part1.db", "TMP/part2.db", "TMP/part3.db")
            .contains("part 2/3, 0 games stored, 4 were there already"));
        assertEquals(games("whole"), games("parts"));
        assertEquals(GAMES, games("parts").size());

        // A run goes on behind them, and a part that is played again on top has nothing to do.
        done("run", "TMP/parts", "--games", "14", "--quiet");
        done("run", "TMP/whole", "--games", "14", "--quiet");
        assertEquals(games("whole"), games("parts"));
        assertTrue(done("shard", "TMP/parts", "--part", "1/3", "--games", Integer.toString(GAMES), "--out",
            "TMP/part1.db").contains("Part 1/3: 0 games played, 4 in "));
    }

    @Test
    void aPartOfAnotherLeagueIsRefusedByName() throws IOException {
        make("parts", "5");
        shard("parts", 1, 3);
        make("seed", "6");
        league("merge", "TMP/seed", "TMP/part1.db")
            .assertRefused("part1.db: found a part of the seed 5, expected the league's, 6");
        done("init", "TMP/scene", "--scene", "duel", "--seed", "5");
        fix("scene");
        done("add", "TMP/scene", "fast=codingame:" + bots.driver());
        done("add", "TMP/scene", "still=codingame:" + bots.idler(0));
        league("merge", "TMP/scene", "TMP/part1.db")
            .assertRefused("part1.db: found a part of another season, expected one of this league's: the scene "
                + "duel has been changed");
        done("init", "TMP/bots", "--scene", "TMP/short.json", "--seed", "5");
        fix("bots");
        done("add", "TMP/bots", "fast=codingame:" + bots.driver());
        done("add", "TMP/bots", "still=codingame:" + bots.idler(7));
        league("merge", "TMP/bots", "TMP/part1.db").assertRefused("part1.db: found games of still as another program");
        league("shard", "TMP/parts", "--part", "2/3", "--games", "12", "--out", "TMP/part1.db")
            .assertRefused("part1.db: found part 1/3, expected part 2/3");
        league("shard", "TMP/parts", "--part", "1/3", "--games", "24", "--out", "TMP/part1.db")
            .assertRefused("part1.db: found a part of 12 games, expected one of 24");
        league("merge", "TMP/parts", "TMP/parts/league.json").assertRefused("found no database");
    }

    /** Does something to the rows of a part. */
    private void edit(String sql, Object... values) throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + folder.resolve("part1.db"));
             PreparedStatement statement = connection.prepareStatement(sql)) {
            for (int k = 0; k < values.length; k++) {
                statement.setObject(k + 1, values[k]);
            }
            assertTrue(statement.executeUpdate() > 0 || sql.startsWith("CREATE"), sql);
        }
    }

    private byte[] transcript() throws SQLException {
        try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + folder.resolve("part1.db"));
             Statement statement = connection.createStatement();
             ResultSet row = statement.executeQuery("SELECT text FROM transcript WHERE game = 1")) {
            return row.getBytes(1);
        }
    }

    /** Puts another transcript into the place of the first game's. */
    private void put(byte[] gzip) throws SQLException {
        edit("UPDATE transcript SET text = ? WHERE game = 1", (Object) gzip);
    }

    /** Changes rows with their digests. */
    private void forge(String sql) throws SQLException {
        edit(sql);
        SealedRows.ofPart(folder.resolve("part1.db"));
    }

    private void put(String text) throws SQLException {
        put(GzipText.compressed(text.getBytes(StandardCharsets.UTF_8)));
    }

    private void refused(String what) {
        Cli cli = league("merge", "TMP/parts", "TMP/part1.db");
        cli.assertRefused(what);
        assertEquals(List.of(), games("parts"), "nothing of it is stored");
    }

    @Test
    void whatDoesNotFollowFromTheCommandsIsRefused() throws IOException, SQLException {
        make("parts", "5");
        shard("parts", 1, 3);
        byte[] whole = transcript();
        String text = new String(GzipText.bytes(whole), StandardCharsets.UTF_8);

        put(text.replaceFirst("\"x\":(\\d)", "\"x\":1$1"));
        refused("differs when it is played again: found states of the hash");
        put(text.substring(0, text.length() / 2));
        refused("bytes, expected a whole game");
        put(new byte[] {1, 2, 3});
        refused("cannot be unpacked");
        edit("UPDATE transcript SET text = (SELECT text FROM transcript WHERE game = 2) WHERE game = 1");
        refused("found 8 turns, ranks 0 1, expected as in its transcript 8 turns, ranks 1 0");
        put(whole);

        edit("UPDATE game SET ranks = '1 0' WHERE id = 1");
        refused("table game, row id = 1, column ranks: found '1 0'");
        edit("UPDATE game SET ranks = '0 1', turns = 7 WHERE id = 1");
        refused("table game, row id = 1, column digest: found");
        forge("UPDATE game SET turns = 7 WHERE id = 1");
        refused("found 7 turns");
        forge("UPDATE game SET counts = 0 WHERE id = 2");
        refused("found attempt 1 that does not count, expected that the last one counts");
        forge("UPDATE game SET decision = 3, seed = 9 WHERE id = 1");
        refused("found decision 3 with the seed 9, expected a game of part 1/3");
    }

    /** Plays a game of these bots: a transcript of which everything follows from the commands. */
    private byte[] forged(long seed, String... commands) throws InterruptedException {
        Contest contest = Contest.of(Games.open(folder.resolve("short.json").toString()), List.of(commands),
            Protocol.JSON, 1);
        TranscriptWriter transcript = new TranscriptWriter(List.of(commands), contest.sandbox());
        contest.play(seed, 0, null, transcript);
        return transcript.compressed();
    }

    @Test
    void commandsThatAreNotTheBotsOwnAreFound() throws IOException, SQLException, InterruptedException {
        make("parts", "5");
        shard("parts", 1, 3);
        // The first game is that of fast against still; here the winner stands still, too.
        put(forged(5, "fast=codingame:" + bots.idler(0), "still=codingame:" + bots.idler(0)));
        refused("fast answers otherwise when it is asked again: turn 1, command[0].x");
        assertTrue(done("merge", "TMP/parts", "TMP/part1.db", "--again", "0")
            .endsWith("bots were asked again in 0 games\n"), "with 0 it is believed");
    }

    /** A share of which no draw is: the first 20 are asked again, and none of the other two. */
    @Test
    @Tag("campaign")
    void botsOfTheFirstTwentyGamesAreAskedAgainWhateverTheShare() throws IOException {
        make("parts", "5");
        done("shard", "TMP/parts", "--part", "1/1", "--games", "22", "--out", "TMP/part1.db");
        LeagueFolder league = new LeagueFolder(folder.resolve("parts"));
        LeagueSettings settings = league.read();
        Contest contest = LeagueOpening.contest(league, settings, new Streams(OutputStream.nullOutputStream(),
            OutputStream.nullOutputStream(), false, false));
        Season season = Season.of(contest.setup(), settings);
        try (GameStore store = GameStore.write(league);
             PartStore part = PartStore.read(folder.resolve("part1.db"))) {
            int number = SeasonOpening.open(league, settings, store, season, false);
            Roster roster = new RosterReader(store, contest, LeagueOpening.environment(settings), false, what -> { },
                () -> 0).read(settings);
            PartMerge merge = new PartMerge(league, store, season, number, roster, contest,
                Games.types(), Double.MIN_VALUE);
            assertEquals(new PartMerge.Merged(22, 0, 20), merge.merge(part, "part1.db"));
        }
    }

    /** Parts held replays before; such a file stays as it is. */
    @Test
    void aPartOfTheEarlierFormIsRefusedByName() throws IOException, SQLException {
        make("parts", "5");
        shard("parts", 1, 3);
        edit("CREATE TABLE recording (game INTEGER PRIMARY KEY REFERENCES game, replay BLOB NOT NULL)");
        byte[] before = Files.readAllBytes(folder.resolve("part1.db"));
        refused("part1.db: found a part with replays, expected one with transcripts");
        league("shard", "TMP/parts", "--part", "1/3", "--games", Integer.toString(GAMES), "--out", "TMP/part1.db")
            .assertRefused("part1.db: found a part with replays, expected one with transcripts");
        assertArrayEquals(before, Files.readAllBytes(folder.resolve("part1.db")));
    }
}
