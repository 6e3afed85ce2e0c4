package steward.cli.league;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.cli.league.view.LeagueOpening;
import steward.cli.streams.Streams;
import steward.league.LeagueFolder;
import steward.league.store.MadeUpGames;
import steward.machines.token.SharedBrokerKey;

/** The commands of a league that play nothing. */
@Execution(ExecutionMode.CONCURRENT)
class LeagueCommandTest {

    @TempDir
    private Path folder;

    private Cli league(String... words) {
        return Cli.league(folder, words);
    }

    private String done(String... words) {
        return league(words).done().out();
    }

    private String refused(String... words) {
        Cli cli = league(words);
        assertEquals(2, cli.status(), cli.out());
        return cli.err().replace(folder.toString(), "TMP");
    }

    private void generated(String name, int games) {
        done("init", "TMP/" + name, "--scene", "duel", "--seed", "1");
        MadeUpGames.fill(new LeagueFolder(folder.resolve(name)), games, 3);
    }

    @Test
    @Tag("slow")
    void gamesWhoseNamesAreWrongAreNotImported() throws IOException {
        generated("a", 300);
        done("init", "TMP/b", "--scene", "duel");
        Files.writeString(folder.resolve("games.jsonl"), done("export", "TMP/a").replaceFirst("\"seed\":\"\\d+\"",
            "\"seed\":\"987654\""));
        assertTrue(refused("import", "TMP/b", "TMP/games.jsonl").startsWith("steward: TMP/games.jsonl:1: name: "));
        assertTrue(refused("table", "TMP/b").contains("has been played"), "nothing was stored");
    }

    /** Games that a league would play itself are its own when it comes to them; others are beside its schedule. */
    @Test
    @Tag("slow")
    void importedGamesOfOtherSeedsAreNotThoseOfTheSchedule() throws IOException {
        ShellBots.shortDuel(folder);
        for (String[] league : new String[][] {{"a", "1"}, {"same", "1"}, {"other", "20"}}) {
            String path = "TMP/" + league[0];
            done("init", path, "--scene", "TMP/short.json", "--seed", league[1]);
            done("add", path, "one=builtin:racer", "two=builtin:regular");
            if (!league[0].equals("a")) {
                done("import", path, "TMP/games.jsonl");
            }
            assertTrue(done("run", path, "--games", "6").contains((league[0].equals("same") ? "0" : "6")
                + " games in this run"), league[0]);
            done("export", path, "--out", "TMP/games.jsonl", "--overwrite");
            assertEquals(league[0].equals("other") ? 12 : 6, Files.readAllLines(folder.resolve("games.jsonl")).size());
        }
        assertTrue(done("run", "TMP/same", "--games", "8").contains("2 games in this run"));
    }

    /** What {@code add} refuses comes in by no other way. */
    @Test
    @Tag("slow")
    void namesThatAddRefusesAreNotImported() throws IOException {
        generated("a", 6);
        String games = done("export", "TMP/a");
        done("init", "TMP/b", "--scene", "duel");
        for (String name : List.of("a,b", "=cmd()", "a\\nb", "\\u001b[2J", "x".repeat(300), "a b", "a@elsewhere")) {
            Files.writeString(folder.resolve("games.jsonl"), games.replace("\"bot\":\"bot-1\"",
                "\"bot\":\"" + name + "\""));
            String refused = refused("import", "TMP/b", "TMP/games.jsonl");
            assertTrue(refused.matches("steward: TMP/games.jsonl:\\d: bot: found '[^\\p{Cntrl}]{1,60}', expected 1 to "
                + "100 letters, digits, dots, underscores and hyphens\n"), refused);
        }
        for (String field : List.of("command", "machine")) {
            Files.writeString(folder.resolve("games.jsonl"), games.replaceFirst("\"" + field + "\":\"",
                "$0\\\\u001b"));
            String refused = refused("import", "TMP/b", "TMP/games.jsonl");
            assertTrue(refused.contains(":1: " + field + ": found '\\u001B"), refused);
        }
        assertTrue(refused("table", "TMP/b").contains("has been played"), "nothing was stored");
        Files.writeString(folder.resolve("games.jsonl"), games.replace("\"bot\":\"bot-1\"", "\"bot\":\"-x\""));
        assertEquals("6 games stored\n", done("import", "TMP/b", "TMP/games.jsonl"));
        assertTrue(done("table", "TMP/b", "--csv").contains(",'-x,"));
        assertTrue(done("export", "TMP/b", "--format", "csv").contains(",'-x,"));
    }

    @Test
    void aBackupIsALeaguesDatabase() throws IOException {
        generated("a", 50);
        done("backup", "TMP/a", "TMP/copy.db");
        done("init", "TMP/b", "--scene", "duel");
        Files.move(folder.resolve("copy.db"), folder.resolve("b/league.db"));
        assertEquals(done("table", "TMP/a"), done("table", "TMP/b"));
    }

    @Test
    void aCopyThatCannotBeWrittenIsSaidToBeIt() {
        generated("a", 2);
        assumeTrue(Files.isDirectory(Path.of("/proc")), "skipped: there is no folder in which nobody may write");
        assertTrue(refused("backup", "TMP/a", "/proc/copy.db").startsWith("steward: /proc/copy.db: cannot be written"));
    }

    @Test
    void aFolderThatIsClosedIsNotOneWithoutALeague() throws IOException {
        generated("a", 2);
        Path closed = folder.resolve("a");
        Set<PosixFilePermission> before = Files.getPosixFilePermissions(closed);
        Files.setPosixFilePermissions(closed, Set.of());
        try {
            assumeTrue(!Files.isExecutable(closed), "skipped: this user may do everything");
            assertEquals("steward: TMP/a: cannot be read: no permission\n", refused("table", "TMP/a"));
        } finally {
            Files.setPosixFilePermissions(closed, before);
        }
    }

    @Test
    @Tag("process")
    void aRunTakesItsFolderFromOthersAndSaysHowBurnersAreHeld() throws IOException {
        assumeTrue(folder.getFileSystem().supportedFileAttributeViews().contains("posix"), "skipped: no POSIX files");
        ShellBots.shortDuel(folder);
        TextShellBots bots = new TextShellBots(folder);
        done("init", "TMP/a", "--scene", "TMP/short.json", "--seed", "1");
        done("add", "TMP/a", "one=codingame:" + bots.driver());
        done("add", "TMP/a", "two=codingame:" + bots.idler(0));
        String[] run = {"run", "TMP/a", "--games", "2"};
        Path league = folder.resolve("a");
        String open = league + " was open to other users";
        assertFalse(league(run).done().err().contains(open), "as it was made");
        Files.setPosixFilePermissions(league, PosixFilePermissions.fromString("rwxr-x---"));
        String said = league(run).done().err();
        assertTrue(said.contains("steward: warning: " + open + " of this machine, with its keys and replays "
            + "(rwxr-x---): now it is its owner's alone"), said);
        assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(league)));
        String held = LeagueOpening.contest(new LeagueFolder(league), new LeagueFolder(league).read(),
            new Streams(OutputStream.nullOutputStream(), OutputStream.nullOutputStream(), false, false)).hold();
        assertTrue(said.contains(held), said);
    }

    @Test
    @Tag("process")
    void everyCommandThatWritesTakesTheFolderFromOthers() throws IOException {
        assumeTrue(folder.getFileSystem().supportedFileAttributeViews().contains("posix"), "skipped: no POSIX files");
        generated("a", 6);
        SharedBrokerKey.put(new LeagueFolder(folder.resolve("a")));
        done("export", "TMP/a", "--out", "TMP/a.jsonl");
        Path league = folder.resolve("a");
        String[][] writing = {{"add", "TMP/a", "one=sh -c 'exit 1'"}, {"rename", "TMP/a", "one", "two"},
            {"retire", "TMP/a", "two"}, {"resume", "TMP/a", "two"}, {"prune", "TMP/a", "--keep", "none"},
            {"verify", "TMP/a", "--drop"}, {"import", "TMP/a", "TMP/a.jsonl"},
            {"worker", "add", "TMP/a", "lab", "--out", "TMP/lab.token"}, {"worker", "revoke", "TMP/a", "lab"}};
        for (String[] command : writing) {
            Files.setPosixFilePermissions(league, PosixFilePermissions.fromString("rwxr-xr-x"));
            String said = league(command).done().err();
            assertTrue(said.contains("warning: " + league + " was open to other users"), command[0] + ": " + said);
            assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(league)), command[0]);
        }
        Files.setPosixFilePermissions(league, PosixFilePermissions.fromString("rwxr-xr-x"));
        assertEquals("", league("table", "TMP/a").err());
        assertEquals("rwxr-xr-x", PosixFilePermissions.toString(Files.getPosixFilePermissions(league)), "only read");
    }

    /** A thread that stores games polls until the run is over: one that never began had no end. */
    @Test
    void aRunThatIsRefusedLeavesNoThread() throws IOException, InterruptedException {
        done("init", "TMP/a", "--scene", "duel", "--seed", "1");
        done("add", "TMP/a", "one=builtin:racer");
        done("add", "TMP/a", "two=builtin:regular");
        ThreadGroup group = new ThreadGroup("run");
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            FutureTask<String> run = new FutureTask<>(() -> refused("run", "TMP/a", "--watch", "--port",
                Integer.toString(taken.getLocalPort())));
            new Thread(group, run).start();
            assertTrue(run.get().contains("cannot listen on port"), run.get());
        } catch (ExecutionException failed) {
            throw new AssertionError(failed.getCause());
        }
        Thread[] left = new Thread[group.activeCount() + 100];
        int count = group.enumerate(left);
        assertEquals(List.of(), Stream.of(left).limit(count).map(Thread::getName)
            .filter(name -> name.equals("league writer")).toList());
    }
}
