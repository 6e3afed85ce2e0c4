package steward.cli.pages;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import steward.bot.Bot;
import steward.bots.BundledBots;
import steward.bots.fantasticbits.Captain;
import steward.bots.fantasticbits.Chaser;
import steward.bots.meanmax.Gatherer;
import steward.bots.meanmax.Marauder;
import steward.bots.pokerchiprace.Glutton;
import steward.bots.pokerchiprace.Nibbler;
import steward.bots.searchrace.Planner;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.league.page.EmbeddedReplays;
import steward.league.page.LeaguePage;
import steward.league.page.LeagueView;
import steward.league.page.PageTestLeague;
import steward.match.TestScenes;
import steward.replay.Recorded;
import steward.replay.page.PageTestBrowser;
import steward.replay.page.PageTestCrowd;
import steward.replay.page.PageTestPages;
import steward.replay.page.PageTestRaces;

/** Every page that Steward writes, at a moment that shows most of it. */
final class PageGallery {

    /** Pages of matches: a canvas with a strip and details beside it. */
    static final List<String> MATCHES = List.of("mad-pod-racing", "walled-race", "search-race", "mean-max",
        "fantastic-bits", "poker-chip-race", "crowd", "undrawn");
    static final List<String> ALL = Stream.concat(MATCHES.stream(), Stream.of("league", "tournament", "author"))
        .toList();

    /** The page of a league with few bots and games: every kind of part of it, few of each. */
    static final String SMALL_LEAGUE = "small-league";

    private static final int LEAGUE_BOTS = 25;
    private static final int LEAGUE_ROUNDS = 4;
    private static final int FEW_BOTS = 4;
    /** A guest's match: what its bots said, and no drawing. */
    private static final List<String> UNDRAWN = List.of("""
        {"type":"steward-replay","format":3,"game":"guest","seed":"7","timeFactor":1,"players":[{"name":"left"},\
        {"name":"right"}],"scene":{"name":"guest"},"drawing":{"field":{"x":0,"y":0,"width":1600,"height":900}},\
        "start":{"state":{}}}""", """
        {"type":"turn","turn":1,"commands":[{"lines":["ROCK","good luck"]},null],"stderr":["depth 4",null],\
        "outcome":{"state":{"asked":1,"said":[{"block":"SUMMARY","lines":["left shows something"]},\
        {"block":"NEXT_PLAYER_INPUT","lines":["1","good luck"]},{"block":"NEXT_PLAYER_INFO","lines":["1","1","50"]}\
        ]}}}""", """
        {"type":"turn","turn":2,"commands":[null,null],"faults":[null,"no answer within 50 ms"],\
        "outcome":{"state":{"asked":0,"said":[{"block":"NEXT_PLAYER_INPUT","lines":["you lead"]},\
        {"block":"NEXT_PLAYER_INFO","lines":["0","2","50"]}]}}}""");

    private final Path folder;
    private final PageTestPages pages;
    private final Map<String, Path> written = new HashMap<>();

    /** @param folder an empty one */
    PageGallery(Path folder) {
        this.folder = folder;
        pages = new PageTestPages(folder);
    }

    /** Opens a page at its moment. */
    void show(PageTestBrowser browser, String name) throws IOException {
        switch (name) {
            case "crowd" -> openLines(browser, PageTestCrowd.lines(500), "30.5");
            case "undrawn" -> openLines(browser, UNDRAWN, "2");
            case "league" -> browser.open(league(LEAGUE_BOTS, LEAGUE_ROUNDS), "");
            case SMALL_LEAGUE -> browser.open(league(FEW_BOTS, 1), "");
            case "tournament" -> browser.openPlain(tournament().resolve("index.html"));
            case "author" -> browser.openPlain(tournament().resolve("bots/crash.html"));
            default -> browser.open(written.computeIfAbsent(name, title -> pages.page(played(title), title)),
                "#t=" + (name.equals("poker-chip-race") ? "9.5" : "30.5"));
        }
    }

    private void openLines(PageTestBrowser browser, List<String> lines, String time) {
        browser.open(pages.live("Made up"), "");
        browser.run("arguments[0].forEach(line => steward.addTurn(line))", lines);
        browser.run("location.hash = '#t=" + time + "'");
        browser.await("the page does not go to " + time, () -> browser.is("steward.time() === " + time));
        browser.run("document.getElementById('notice').hidden = true");
        browser.complaints();                                // about the feed, which nobody serves
    }

    private static byte[] played(String scene) {
        return switch (scene) {
            case "search-race" -> played(scene, BundledBots.of(new Planner()));
            case "mean-max" ->
                played(scene, BundledBots.of(new Marauder()), BundledBots.of(new Gatherer()),
                    BundledBots.of(new Gatherer()));
            case "fantastic-bits" -> played(scene, BundledBots.of(new Captain()), BundledBots.of(new Chaser()));
            case "poker-chip-race" -> played(scene, BundledBots.of(new Glutton()), BundledBots.of(new Nibbler()));
            default -> PageTestRaces.play(PageTestRaces.scene(scene), 3);
        };
    }

    private static byte[] played(String scene, Bot... bots) {
        return Recorded.of(TestScenes.open(scene), 7, List.of(bots)).bytes();
    }

    private Path league(int bots, int rounds) throws IOException {
        Path page = folder.resolve("league-of-" + bots + ".html");
        LeagueView view = PageTestLeague.of(bots, rounds);
        return Files.write(page, LeaguePage.of(view, folder, EmbeddedReplays.of(view.games(), folder, null, null,
            game -> "Game " + game.id()), "League night"));
    }

    /** Two programs that play, one that crashes, one that does not compile. */
    private Path tournament() throws IOException {
        Path out = folder.resolve("tournament");
        if (Files.exists(out)) {
            return out;
        }
        ShellBots.shortDuel(folder);
        for (String name : List.of("left", "right", "crash")) {
            Path own = Files.createDirectories(folder.resolve("in").resolve(name));
            Files.writeString(own.resolve("run"), name.equals("crash") ? "sh -c 'read -r setup; exit 3'"
                : "sh -c 'read -r setup; while read -r turn; do echo \"{\\\"pods\\\":[{\\\"x\\\":1,\\\"y\\\":1,"
                    + "\\\"thrust\\\":100}]}\"; done'");
        }
        Files.writeString(folder.resolve("in/broken.cpp"), "int main() { return <b>; }\n");
        Cli cli = Cli.run("tournament", folder.resolve("in").toString(), "--scene",
            folder.resolve("short.json").toString(), "--games", "1", "--protocol", "json", "--page", out.toString());
        assertEquals(0, cli.status(), cli.err());
        return out;
    }
}
