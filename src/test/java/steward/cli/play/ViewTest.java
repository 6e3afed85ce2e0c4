package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.cli.ProcessTest;
import steward.cli.Recorded;
import steward.cli.ShellBots;
import steward.cli.shared.ExitStatus;

/** {@code --view} and {@code --open} of matches and replays. That pages show what they hold is tested elsewhere. */
@Timeout(60)
class ViewTest {

    @TempDir
    private Path folder;

    private Path replay() throws IOException {
        return Files.write(folder.resolve("x.jsonl"), Recorded.duel(3).bytes());
    }

    private String[] match(String... more) {
        ShellBots bots = new ShellBots(folder);
        return Cli.words(List.of("match", "--scene", "duel", "--no-deadline", "--bot",
            bots.driver("near", ShellBots.CHECKPOINT), "--bot", bots.driver("far", ShellBots.NOWHERE)), more);
    }

    private static void assertPage(Path page, String title) throws IOException {
        String html = Files.readString(page);
        assertTrue(html.startsWith("<!DOCTYPE html>") && html.strip().endsWith("</html>"), "it is whole");
        assertTrue(html.contains("<title>" + title + "</title>"));
        assertTrue(html.contains("type=\"application/octet-stream\" >H4sI"), "it holds a replay");
        assertTrue(html.contains("<script id=\"details\" type=\"application/octet-stream\">H4sI"),
            "it holds what bots were sent");
    }

    @Test
    void aReplayBecomesAPage() throws IOException {
        Path page = folder.resolve("x.html");
        Cli cli = Cli.run("replay", replay().toString(), "--view", page.toString()).done();
        assertEquals("Page: " + page + "\n", cli.out());
        assertEquals("", cli.err());
        assertPage(page, "pilot-0 against pilot-1");
    }

    @Test
    void aReplayThatWasCutOffIsShownUpToTheCut() throws IOException {
        byte[] whole = Recorded.duel(3).bytes();
        Path cut = Files.write(folder.resolve("cut.jsonl"), Arrays.copyOf(whole, whole.length / 2));
        Path page = folder.resolve("x.html");
        Cli cli = Cli.run("replay", cut.toString(), "--view", page.toString(), "--quiet").done();
        assertEquals("", cli.out());
        assertTrue(cli.err().startsWith("steward: warning: " + cut + ": cut off within the line after "), cli.err());
        assertTrue(Files.readString(page).contains("data-warning=\"This recording was cut off within"));
        Path header = Files.write(folder.resolve("header.jsonl"), Arrays.copyOf(whole, 100));
        Cli.run("replay", header.toString(), "--view", page.toString(), "--overwrite").done();
        assertTrue(Files.readString(page).contains("<title>header.jsonl</title>"));
    }

    @Test
    @Tag("process")
    void aPictureWithoutABrowserSaysHowToHaveOne() throws IOException, InterruptedException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Path picture = folder.resolve("x.png");
        String said = ProcessTest.shell("PATH=" + folder + " "
            + ProcessTest.steward("replay", replay().toString(), "--picture", picture.toString()));
        assertEquals("steward: --picture: " + picture + ": found no browser on the PATH, expected one of chromium, "
            + "chromium-browser, google-chrome, chrome, microsoft-edge, msedge; or open the page and press "
            + "P\nstatus 1\n", said);
        assertFalse(Files.exists(picture));
    }

    @Test
    @Tag("process")
    void aMatchBecomesAPageWithoutAReplay() throws IOException {
        Path page = folder.resolve("m.html");
        Cli cli = Cli.run(match("--view", page.toString(), "--json")).done();
        assertEquals(51, cli.json().get("turns").intValue());
        assertEquals("Page: " + page + "\n", cli.err());
        assertPage(page, "near against far");
    }

    @Test
    @Tag("process")
    void thePageOfAMatchIsThatOfItsReplay() throws IOException {
        Path page = folder.resolve("m.html");
        Path file = folder.resolve("m.jsonl");
        Cli cli = Cli.run(match("--view", page.toString(), "--out", file.toString()));
        assertTrue(cli.out().contains("near wins: ") && cli.out().endsWith("Page: " + page + "\n"), cli.out());
        Path again = folder.resolve("again.html");
        assertEquals(ExitStatus.DONE, Cli.run("replay", file.toString(), "--view", again.toString()).status());
        assertEquals(Files.readString(again), Files.readString(page));
        assertEquals(ExitStatus.DONE, Cli.run("replay", file.toString(), "--verify").status());
    }

    @Test
    @Tag("process")
    void aPageThatExistsIsKeptUnlessItMayBeReplaced() throws IOException {
        Path page = Files.writeString(folder.resolve("x.html"), "precious");
        refused(page + ": exists already, and is kept", "replay", replay().toString(), "--view", page.toString());
        refused(page + ": exists already, and is kept", match("--view", page.toString()));
        assertEquals("precious", Files.readString(page));
        assertEquals(ExitStatus.DONE,
            Cli.run("replay", replay().toString(), "--view", page.toString(), "--overwrite").status());
        assertPage(page, "pilot-0 against pilot-1");
        assertEquals(ExitStatus.DONE, Cli.run(match("--view", page.toString(), "--overwrite")).status());
        assertPage(page, "near against far");
    }

    /** The old page was gone although nothing was played. */
    @Test
    void aPageThatExistsStaysUntilThereIsANewOne() throws IOException {
        Path page = Files.writeString(folder.resolve("x.html"), "precious");
        String missing = folder + "/missing/a.jsonl";
        refused(missing, match("--view", page.toString(), "--overwrite", "--out", missing));
        assertEquals("precious", Files.readString(page));
        if (Files.isWritable(Path.of("/dev/full"))) {
            assertEquals(ExitStatus.FAILED,
                Cli.run(match("--view", page.toString(), "--out", "/dev/full", "--overwrite")).status());
            assertEquals("precious", Files.readString(page));
        }
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(List.of(), left.filter(file -> file.toString().endsWith(".part")).toList());
        }
    }

    private static void refused(String message, String... call) {
        Cli.run(call).assertRefused(message);
    }

    @Test
    void whatCannotBeWrittenIsFoundBeforeTheMatch() throws IOException {
        Path played = folder.resolve("played");
        for (String view : new String[] {folder + "/missing/x.html", folder.toString(), "/proc/x.html"}) {
            String bot = "sh -c 'touch " + played + "'";
            refused(view, "match", "--scene", "duel", "--bot", bot, "--bot", bot, "--view", view);
            refused(view, "replay", replay().toString(), "--view", view);
        }
        assertFalse(Files.exists(played));
    }

    @Test
    void aReplayIsNeverReplacedByItsPage() throws IOException {
        Path file = replay();
        refused("found the replay itself", "replay", file.toString(), "--view", file.toString(), "--overwrite");
        Path link = Files.createSymbolicLink(folder.resolve("link.html"), file);
        refused("found the replay itself", "replay", file.toString(), "--view", link.toString(), "--overwrite");
        assertEquals(ExitStatus.DONE, Cli.run("replay", file.toString(), "--verify").status());
        Path both = folder.resolve("both");
        refused("found the file of --out", match("--view", both.toString(), "--out", folder + "/./both"));
        assertFalse(Files.exists(both));
    }

    @Test
    void aMatchThatCannotEndLeavesNoPage() {
        assumeTrue(Files.isWritable(Path.of("/dev/full")), "there is no /dev/full");
        Path page = folder.resolve("x.html");
        Cli cli = Cli.run(match("--view", page.toString(), "--out", "/dev/full", "--overwrite"));
        assertEquals(ExitStatus.FAILED, cli.status());
        assertFalse(Files.exists(page));
    }

    /** As a process of its own, since the programs that are found depend on its environment. */
    @Test
    @Tag("process")
    @Tag("campaign")
    void itIsOpenedInTheBrowserOfTheSystem() throws IOException, InterruptedException {
        assumeTrue(ShellBots.runnable(), "there is no /bin/sh");
        Path opener = Files.writeString(folder.resolve("xdg-open"), "#!/bin/sh\necho \"$1\" >" + folder + "/opened\n");
        Files.setPosixFilePermissions(opener, PosixFilePermissions.fromString("rwxr-xr-x"));
        Path page = folder.resolve("a page.html");
        Path replay = replay();
        String view = ProcessTest.steward("replay", replay.toString(), "--view", page.toString(), "--open");
        String said = ProcessTest.shell("DISPLAY=:0 PATH=" + folder + ":$PATH " + view);
        assertEquals("Page: " + page + "\nstatus 0\n", said);
        assertEquals(page.toUri() + "\n", Files.readString(folder.resolve("opened")));
        String open = ProcessTest.steward("replay", replay.toString(), "--open", "--quiet");
        String without = ProcessTest.shell("unset DISPLAY WAYLAND_DISPLAY BROWSER; " + open);
        assertTrue(without.startsWith("steward: no browser could be opened: there is no display to show it on; "
            + "the page is at file:///") && without.endsWith("status 0\n"), without);
        Path unnamed = Path.of(URI.create(without.substring(without.indexOf("file:"), without.indexOf('\n'))));
        assertEquals(Files.readString(page), Files.readString(unnamed));
        Files.delete(unnamed);
    }
}
