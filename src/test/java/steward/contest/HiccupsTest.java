package steward.contest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.FaultMessages;
import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.cli.shared.Games;
import steward.files.InputException;
import steward.game.Game;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TimeControl;
import steward.match.Turn;

/** Games that were lost on time on a starved machine. How each match ends is written down by the test. */
class HiccupsTest {

    private static final long MS = 1_000_000;

    /** How a match ends for the first bot. */
    enum End {
        /** It wins. */
        WON,
        /** It is late and has computed all the time. */
        SLOW,
        /** It is late and has waited for a processor. */
        STARVED,
        /** It is late, and has waited a tenth of its time for a processor. */
        DOUBTFUL,
        /** It is starved by its own CPU time. */
        USED_UP
    }

    @TempDir
    private Path folder;
    private final List<String> played = new ArrayList<>();

    private static Contest contest() {
        List<Contest.Entrant> entrants = Stream.of("me", "other")
            .map(name -> new Contest.Entrant(name, name, Protocol.JSON, List.of())).toList();
        return new Contest(Games.open("duel"), entrants, new TimeControl(1000 * MS, 75 * MS), 1);
    }

    static TimeSpent spent(End end) {
        long waited = switch (end) {
            case SLOW -> 0;
            case DOUBTFUL -> 8 * MS;
            default -> 56 * MS;
        };
        return new TimeSpent(75 * MS, 76 * MS, 19 * MS, 56 * MS - waited, waited, MS, 57 * MS - waited,
            TimeSpent.Shows.ALL, end == End.USED_UP);
    }

    /** A match of three turns; the first bot is late in the last, or not at all. */
    private MatchResult match(Contest attempt, List<End> ends, long seed, int rotation, OutputStream recording,
                              MatchListener follower) {
        End end = ends.get(played.size());
        played.add(seed + "/" + rotation + " " + end
            + (attempt.time().basis() == TimeBasis.UNSTARVED ? " unstarved" : ""));
        int me = rotation == 0 ? 0 : 1;
        Game game = contest().setup().create(seed);
        follower.start(game, contest().setup().codec(game));
        try {
            if (recording != null) {
                recording.write(("header\n" + end + "\n").getBytes(StandardCharsets.US_ASCII));
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        String fault = null;
        if (end != End.WON) {
            Turn turn = Turn.of(3, 2);
            fault = FaultMessages.missed(spent(end), TimeBasis.WALL, false, 0, 1, 0);
            turn.fail(me, fault, null, 76 * MS);
            turn.late(me, spent(end));
            follower.commands(turn);
        }
        List<MatchResult.PlayerResult> players = new ArrayList<>();
        for (int player = 0; player < 2; player++) {
            boolean lost = player == me == (end != End.WON);
            String why = player == me ? fault : null;
            players.add(new MatchResult.PlayerResult(player == me ? "me" : "other", lost ? 1 : 0, lost ? 0 : 1, why,
                why, 3, MS, MS, MS, 0));
        }
        return new MatchResult(3, "all others are out", players);
    }

    private Standings play(Hiccups hiccups, KeptReplays keep, int seeds, End... ends) throws InterruptedException {
        Series series = new Series(contest(), 5, seeds, true, folder, keep, hiccups);
        series.prepare(false);
        SeriesPlay play = new SeriesPlay(series, false, (attempt, seed, rotation, recording, follower)
            -> match(attempt, List.of(ends), seed, rotation, recording, follower));
        int[] steps = new int[1];
        play.play(1, () -> steps[0]++);
        assertEquals(2 * seeds, steps[0]);
        assertNull(play.stopped());
        assertEquals(ends.length, played.size());
        return play.standings();
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            List<String> all = new ArrayList<>();
            for (Path file : files.sorted().toList()) {
                all.add(file.getFileName() + " " + Files.readAllLines(file).get(1));
            }
            return all;
        }
    }

    private CountedGame<MatchListener> counted(End... ends) throws InterruptedException, IOException {
        played.clear();
        return CountedGame.play(contest(), 5, Hiccups.REPLAY, () -> new MatchListener() { }, () -> null,
            (attempt, seed, rotation, recording, follower)
                -> match(attempt, List.of(ends), seed, rotation, recording, follower));
    }

    @Test
    void aGameForARatingToolIsPlayedAgainLikewise() throws Exception {
        CountedGame<MatchListener> again = counted(End.STARVED, End.WON);
        assertEquals(List.of("5/0 STARVED", "5/0 WON unstarved"), played);
        assertEquals(0, again.result().players().get(0).rank());
        assertEquals(List.of(), again.failures());
        assertEquals(1, again.again().size());
        assertTrue(again.again().get(0).startsWith("played again, since me lost on time while others used the "
            + "processors, in turn 3: no answer within 75 ms"), again.again().get(0));
        CountedGame<MatchListener> slow = counted(End.SLOW);
        assertEquals(1, slow.result().players().get(0).rank());
        assertEquals(1, slow.failures().size());
        assertEquals(List.of(), slow.again());
        CountedGame<MatchListener> doubted = counted(End.DOUBTFUL, End.SLOW);
        assertEquals(1, doubted.result().players().get(0).rank(), "without what the machine did it is slow");
        assertNull(doubted.discarded());
        CountedGame<MatchListener> never = counted(End.STARVED, End.STARVED, End.STARVED);
        assertEquals("not counted: me waited for a processor that other programs used, in each of 3 attempts",
            never.discarded());
        assertEquals(2, never.again().size());
    }

    @Test
    void aGameLostOnAStarvedMachineIsPlayedAgainWithTheSameSeed() throws Exception {
        Standings standings = play(Hiccups.REPLAY, KeptReplays.ALL, 2, End.WON, End.STARVED, End.WON, End.WON, End.WON);

        assertEquals(List.of("5/0 WON", "5/1 STARVED", "5/1 WON unstarved", "6/0 WON", "6/1 WON"), played);
        assertEquals(4, standings.tally(0).wins());
        assertEquals(0, standings.tally(0).faults());
        assertEquals(0, standings.failures().size());
        Series.Played game = standings.games().get(1);
        assertEquals(List.of(game), standings.playedAgain());
        assertTrue(game.starved().failures().get(0).starved());
        assertEquals(56 * MS, game.starved().failures().get(0).time().waited());
        assertEquals(folder.resolve("game-0002-starved.jsonl"), game.starved().replay());
        assertEquals(folder.resolve("game-0002.jsonl"), game.replay());
        assertEquals(List.of("game-0001.jsonl WON", "game-0002-starved.jsonl STARVED", "game-0002.jsonl WON",
            "game-0003.jsonl WON", "game-0004.jsonl WON"), files());
    }

    /** A bot that is slow without what the machine did has lost; a machine that is too busy thrice gives no result. */
    @Test
    void anAttemptCountsThatTheMachineDidNotSpoil() throws Exception {
        Standings standings = play(Hiccups.REPLAY, KeptReplays.ALL, 1, End.DOUBTFUL, End.SLOW, End.STARVED,
            End.STARVED, End.STARVED);

        assertEquals(List.of("5/0 DOUBTFUL", "5/0 SLOW unstarved", "5/1 STARVED", "5/1 STARVED unstarved",
            "5/1 STARVED unstarved"), played);
        assertEquals(1, standings.tally(0).losses());
        assertEquals(1, standings.tally(0).faults());
        assertEquals(1, standings.results());
        assertEquals(2, standings.playedAgain().size());
    }

    @Test
    void aBotThatIsSlowByItselfHasLost() throws Exception {
        Standings standings = play(Hiccups.REPLAY, KeptReplays.ALL, 1, End.SLOW, End.USED_UP);
        assertEquals(2, standings.tally(0).losses());
        assertEquals(List.of(), standings.playedAgain());
        assertEquals(2, standings.failures().size(), "by the clock, and of CPU time");
    }

    @Test
    void hiccupsCountWhereThatIsAskedFor() throws Exception {
        Standings standings = play(Hiccups.COUNT, KeptReplays.ALL, 1, End.STARVED, End.WON);
        assertEquals(1, standings.tally(0).losses());
        assertTrue(standings.games().get(0).failures().get(0).starved());
        assertEquals(List.of(FailureHints.STARVED), standings.failures().get(0).first().hints());
    }

    /** The first bot lost the first of the two games, and won the second. */
    @Test
    void ofBothGamesWhatIsAskedForIsKept() throws Exception {
        play(Hiccups.REPLAY, KeptReplays.LOST, 1, End.STARVED, End.WON, End.WON);
        assertEquals(List.of("game-0001-starved.jsonl STARVED"), files());
    }

    @Test
    void withoutReplaysNothingIsRenamed() throws Exception {
        Standings standings = play(Hiccups.REPLAY, KeptReplays.NONE, 1, End.STARVED, End.WON, End.WON);
        assertNull(standings.playedAgain().get(0).starved().replay());
        assertEquals(List.of(), files());
    }

    /** A folder stands where the replay of the first game would go: it keeps its name, and counts. */
    @Test
    void aReplayThatCannotBeRenamedEndsTheSeries() throws Exception {
        Files.createDirectories(folder.resolve("game-0001-starved.jsonl/full"));
        Series series = new Series(contest(), 5, 2, false, folder, KeptReplays.ALL, Hiccups.REPLAY);
        SeriesPlay play = new SeriesPlay(series, true, (attempt, seed, rotation, recording, follower)
            -> match(attempt, List.of(End.STARVED), seed, rotation, recording, follower));
        play.play(1, () -> { });
        assertEquals(1, played.size());
        assertTrue(play.stopped().startsWith(folder.resolve("game-0001.jsonl") + ": cannot be renamed: "),
            play.stopped());
        assertEquals(1, play.standings().tally(0).losses());
    }

    @Test
    void replaysOfBothNamesAreLookedForBeforeTheSeries() throws IOException {
        Files.writeString(folder.resolve("game-0002-starved.jsonl"), "");
        Series series = new Series(contest(), 5, 2, false, folder, KeptReplays.ALL, Hiccups.REPLAY);
        InputException refused = assertThrows(InputException.class,
            () -> series.prepare(false));
        assertTrue(refused.getMessage().contains("game-0002-starved.jsonl"), refused.getMessage());
    }

    @Test
    void wordsAreThoseOfTheCall() {
        assertEquals(Hiccups.REPLAY, Hiccups.of("replay").orElseThrow());
        assertEquals("count", Hiccups.COUNT.word());
        assertFalse(Hiccups.of("REPLAY").isPresent());
    }
}
