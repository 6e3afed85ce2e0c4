package steward.cli.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import steward.bot.FaultMessages;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.cli.shared.Games;
import steward.cli.streams.Colour;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.game.Game;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TimeControl;
import steward.match.Turn;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Report on games that were played again because the machine was starved; and wrong calls. */
class StarvedReportTest {

    private static final long MS = 1_000_000;

    private static final TimeSpent SPENT = new TimeSpent(75 * MS, 76 * MS, 19 * MS, 2 * MS, 53 * MS, 2 * MS, 2 * MS,
        TimeSpent.Shows.ALL, false);

    private static final String FAULT = "no answer within 75 ms (waited 76 ms): the machine was busy: not its fault "
        + "[computed 2, waited 53 for a processor, 2 other, 19 before the first look]";

    /** Two games: in the first the bot is late in turn 4, then both have nothing to complain of. */
    private static SeriesPlay play(Hiccups hiccups) throws InterruptedException {
        List<Contest.Entrant> entrants = Stream.of("me", "other")
            .map(name -> new Contest.Entrant(name, name, Protocol.JSON, List.of())).toList();
        Contest contest = new Contest(Games.open("duel"), entrants,
            new TimeControl(1000 * MS, 75 * MS), 1);
        Series series = new Series(contest, 5, 2, false, null, KeptReplays.ALL, hiccups);
        AtomicInteger games = new AtomicInteger();
        SeriesPlay play = new SeriesPlay(series, false, (attempt, seed, rotation, recording, follower) -> {
            boolean late = games.getAndIncrement() == 0;
            String fault = late ? FaultMessages.missed(SPENT, TimeBasis.WALL, false, 0, 1, 0) : null;
            if (late) {
                Turn turn = Turn.of(4, 2);
                turn.fail(0, fault, null, 76 * MS);
                turn.late(0, SPENT);
                Game game = contest.setup().create(seed);
                follower.start(game, contest.setup().codec(game));
                follower.commands(turn);
            }
            return new MatchResult(9, "over", List.of(
                new MatchResult.PlayerResult("me", late ? 1 : 0, 0, fault, fault, 9, MS, MS, MS, 0),
                new MatchResult.PlayerResult("other", late ? 0 : 1, 0, null, null, 9, MS, MS, MS, 0)));
        });
        play.play(1, () -> { });
        return play;
    }

    private static String text(SeriesPlay play, Series series) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        SeriesText.print(new PrintStream(out, true, StandardCharsets.UTF_8), Colour.NONE, series, play.standings());
        return out.toString(StandardCharsets.UTF_8);
    }

    @Test
    void theTextNamesGameBotAndEvidence() throws InterruptedException {
        SeriesPlay play = play(Hiccups.REPLAY);
        String out = text(play, play.series());
        assertTrue(out.contains("""

            Played again, since others used the processors (--hiccups count lets the first game count):
              game 1 (seed 5): me in turn 4: %s
            """.formatted(FAULT)), out);
        assertEquals("2 games of duel: me 1.000, other 0.000; 1 played again",
            SeriesText.headline(play.series(), play.standings()));
    }

    @Test
    void withoutASecondGameItIsAFailureLikeOthers() throws InterruptedException {
        SeriesPlay play = play(Hiccups.COUNT);
        String out = text(play, play.series());
        assertTrue(out.contains("me failed in 1 game, game 1 (seed 5) in turn 4: " + FAULT + "\n"), out);
        assertTrue(!out.contains("Played again"), out);
    }

    private static JsonNode json(SeriesPlay play) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        Streams streams = new Streams(out, out, false, false);
        Json.print(streams, SeriesJson.of(play.series(), play, List.of(), null));
        streams.out().flush();
        return JsonMapper.shared().readTree(out.toString(StandardCharsets.UTF_8));
    }

    @Test
    void jsonHoldsBothGames() throws InterruptedException {
        JsonNode json = json(play(Hiccups.REPLAY));
        assertEquals("wall", json.get("time").stringValue());
        assertEquals("replay", json.get("hiccups").stringValue());
        assertEquals(1, json.get("playedAgain").intValue());
        JsonNode game = json.get("list").get(0);
        assertEquals("[0,1]", game.get("ranks").toString());
        assertEquals("[]", game.get("lateAnswers").toString());
        JsonNode first = game.get("starved");
        assertEquals("[1,0]", first.get("ranks").toString());
        assertEquals("[4,null]", first.get("faultTurns").toString());
        assertEquals(FAULT, first.get("faults").get(0).stringValue());
        assertEquals("[{\"player\":0,\"time\":{\"limitOf\":\"wall\",\"limitMs\":75,\"takenMs\":76,\"unobservedMs\":19,"
            + "\"computedMs\":2,\"waitedMs\":53,\"otherMs\":2,\"cpuMs\":2,\"inSteps\":false,\"starved\":true}}]",
            first.get("lateAnswers").toString());
        assertTrue(json.get("list").get(1).get("starved").isNull());
    }

    @Test
    void jsonOfAGameThatCountsHasTheEvidenceToo() throws InterruptedException {
        JsonNode json = json(play(Hiccups.COUNT));
        assertEquals(0, json.get("playedAgain").intValue());
        assertTrue(json.get("list").get(0).get("lateAnswers").get(0).get("time").get("starved").booleanValue());
        assertEquals(53, json.get("failures").get(0).get("time").get("waitedMs").doubleValue());
    }
}
