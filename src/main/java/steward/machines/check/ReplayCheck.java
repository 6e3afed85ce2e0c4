package steward.machines.check;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import steward.contest.Contest;
import steward.contest.GameFacts;
import steward.files.JarFolder;
import steward.game.GameTypes;
import steward.json.JsonNumbers;
import steward.match.Protocol;
import steward.replay.JsonLine;
import steward.replay.ReplayException;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.replay.verify.Verification;
import steward.scene.json.SceneException;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * Reads what a game came to from its replay, and from nothing else: the replay has to be one of the very match that was
 * asked for, and when it is played again everything has to follow from the commands. Only how long answers took is
 * believed. Thread-safe.
 */
public final class ReplayCheck {

    private final Contest contest;
    private final GameTypes types;

    /** @param contest of the scene; its own bots do not matter */
    public ReplayCheck(Contest contest, GameTypes types) {
        this.contest = contest;
        this.types = types;
    }

    /**
     * A game that has to have been played.
     *
     * @param seed      its seed
     * @param names     that the players go by
     * @param protocols that they speak
     */
    public record Expected(long seed, List<String> names, List<Protocol> protocols) {

        /** Copies the lists. */
        public Expected {
            names = List.copyOf(names);
            protocols = List.copyOf(protocols);
        }
    }

    /**
     * A player of a game.
     *
     * @param rank       0 for the best
     * @param score      the game's own
     * @param fault      how the bot failed, as failures of one kind are called; or {@code null}
     * @param answers    how many were requested
     * @param meanNanos  as it was measured there
     * @param worstNanos as it was measured there
     * @param firstNanos as it was measured there
     */
    public record Seat(int rank, double score, String fault, int answers, long meanNanos, long worstNanos,
                       long firstNanos) {
    }

    /**
     * Result of a game, read from its replay.
     *
     * @param turns how many were played
     * @param facts what a result does not contain
     * @param seats one for each player
     * @param nanos that all answers took together; 0 if they are not summed up
     */
    public record Outcome(int turns, GameFacts facts, List<Seat> seats, long nanos) {

        /** Copies the list. */
        public Outcome {
            seats = List.copyOf(seats);
        }
    }

    /**
     * Plays a replay again.
     *
     * @param source names it in errors
     * @param gzip   the replay, compressed
     * @throws DisprovedException if it is not the replay of that game, or differs when it is played again
     */
    public Outcome check(String source, byte[] gzip, Expected expected) throws DisprovedException {
        try (ReplayReader replay = new ReplayReader(GzipText.open(gzip), source);
             ReplayReader second = new ReplayReader(GzipText.open(gzip), source)) {
            checkHeader(replay, expected);
            int[] asked = new int[contest.players()];
            Verification verification = Verification.of(replay, types, asked);
            if (verification.difference() != null) {
                throw new DisprovedException(source + ": differs when it is played again: "
                    + verification.difference());
            }
            if (!verification.verified()) {
                throw new DisprovedException(source + ": found "
                    + (verification.warning() == null ? "a replay whose signature is wrong" : "a replay that is cut "
                    + "off") + ", expected a whole one");
            }
            return outcome(replay, verification.turns(), GameFacts.of(second, types), asked);
        } catch (ReplayException | SceneException | JacksonException problem) {
            throw new DisprovedException(String.valueOf(problem.getMessage()));
        } catch (IOException | UncheckedIOException problem) {
            throw new DisprovedException(source + ": cannot be unpacked: " + problem.getMessage());
        }
    }

    private void checkHeader(ReplayReader replay, Expected expected) throws DisprovedException {
        ReplayHeader header = replay.header();
        if (header == null) {
            throw new DisprovedException(replay.warning());
        }
        ReplayHeader wanted = new ReplayHeader(contest.setup().scene().gameId(), contest.setup().scene().json(),
            expected.seed(), expected.names(), header.bots(), expected.protocols(), contest.timeFactor(),
            contest.setup().plan().lawVersion(), header.signer(), header.sandbox(),
            JarFolder.digestOf(contest.setup()));
        String wrong = replay.imported() ? "imported"
            : !header.game().equals(wanted.game()) ? "game" : !header.scene().equals(wanted.scene()) ? "scene"
            : header.seed() != wanted.seed() ? "seed" : !header.names().equals(wanted.names()) ? "players"
            : !header.protocols().equals(wanted.protocols()) ? "protocols"
            : !header.equals(wanted) ? "timeFactor or law" : null;
        if (wrong != null) {
            throw new DisprovedException(replay.source() + ":1: " + wrong + ": found that of another game, expected "
                + "the game of seed " + expected.seed() + " between " + String.join(" and ", expected.names()));
        }
    }

    /** The last line has just been compared with what the game came to: but for its times it is as we would write. */
    private Outcome outcome(ReplayReader replay, int turns, GameFacts facts, int... asked) {
        JsonLine result = replay.result();
        List<JsonLine> standing = result.objects("standing");
        String[] faults = result.textsOf("players", "fault");
        JsonLine times = result.has("times") ? new JsonLine(result.where() + ": times", result.object("times")) : null;
        long[] mean = nanos(times, "averageNanos", asked.length);
        long[] worst = nanos(times, "worstNanos", asked.length);
        long[] first = nanos(times, "firstNanos", asked.length);
        List<Seat> seats = new ArrayList<>();
        for (int player = 0; player < asked.length; player++) {
            seats.add(new Seat(standing.get(player).integer("rank"), standing.get(player).number("score", 0),
                faults[player], asked[player], mean[player], worst[player], first[player]));
        }
        return new Outcome(turns, facts, seats, 0);
    }

    /** Returns the measured times; 0 where nothing is said. */
    private static long[] nanos(JsonLine times, String name, int players) {
        long[] nanos = new long[players];
        if (times == null || !times.has(name)) {
            return nanos;
        }
        byte[] array = times.array(name);
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), array, 0, array.length)) {
            in.nextToken();
            int player = 0;
            for (JsonToken token = in.nextToken(); token != JsonToken.END_ARRAY; token = in.nextToken()) {
                if (player == players || token != JsonToken.VALUE_NUMBER_INT || in.getLongValue() < 0) {
                    throw new ReplayException(times.where() + "." + name + ": found something else, expected "
                        + players + " whole numbers from 0");
                }
                nanos[player++] = in.getLongValue();
            }
        }
        return nanos;
    }
}
