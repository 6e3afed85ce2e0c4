package steward.contest;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import steward.Internal;
import steward.contest.repeat.GameFacts;
import steward.contest.seeds.Seeds;
import steward.files.OutputFiles;
import steward.match.MatchResult;

/**
 * Settings of a series: many games between the same bots. Game k, counted from 0, has seed k. With {@code swap} each
 * seed is played once for every rotation of the seats, one after the other. In a scene for one player each bot plays
 * each seed alone, one after the other.
 *
 * @param starts  the seeds: numbers in a row from that of the first game on, or a list
 * @param seeds   how many seeds
 * @param swap    whether the bots change sides
 * @param folder  for the replays, or {@code null}
 * @param keep    which replays are kept when their games are over
 * @param hiccups what becomes of games that a bot lost on time while other programs used the processors
 */
public record Series(Contest contest, @Internal Seeds starts, int seeds, boolean swap, Path folder, KeptReplays keep,
                     Hiccups hiccups) {

    private static final int LEAST_DIGITS = 4;

    /**
     * A game of the series.
     *
     * @param number   counted from 1
     * @param rotation by how many places the bots had moved up
     * @param result   or {@code null} if it could not be brought to one
     * @param failure  why it could not, or {@code null}
     * @param failures of bots, in the order in which they happened, without lines of stderr
     * @param replay   where it is, or {@code null} if there is none
     * @param facts    what the result does not contain
     * @param starved  the same game as it was played before, which does not count since others used the processors,
     *                 see {@link Hiccups#REPLAY}; or {@code null}
     */
    public record Played(int number, long seed, int rotation, MatchResult result, String failure,
                         List<Failure> failures, Path replay, @Internal GameFacts facts, Played starved) {

        /** Copies the list. */
        @Internal
        public Played {
            failures = List.copyOf(failures);
        }

        /** One of which nothing else is known. */
        public Played(int number, long seed, int rotation, MatchResult result, String failure,
                      List<Failure> failures, Path replay, Played starved) {
            this(number, seed, rotation, result, failure, failures, replay, GameFacts.UNKNOWN, starved);
        }

        /** One that was played once. */
        public Played(int number, long seed, int rotation, MatchResult result, String failure,
                      List<Failure> failures, Path replay) {
            this(number, seed, rotation, result, failure, failures, replay, null);
        }

        /** Returns which bot of the call was a player. */
        public int entrantOf(Contest contest, int player) {
            return contest.entrantOf(player, rotation);
        }

        /** Returns which player a bot of the call was, where all of them played. */
        public int playerOf(Contest contest, int entrant) {
            int player = 0;
            while (contest.entrantOf(player, rotation) != entrant) {
                player++;
            }
            return player;
        }

        /** True if there is a result, and all players failed in the same turn: then no player has earned it. */
        public boolean allFailed() {
            return result != null && result.players().size() > 1 && failures.size() == result.players().size()
                && failures.stream().allMatch(failure -> failure.turn() == failures.get(0).turn());
        }

        Played without(String problem) {
            return new Played(number, seed, rotation, null, problem, List.of(), replay, GameFacts.UNKNOWN, starved);
        }

        Played numbered(int other) {
            return new Played(other, seed, rotation, result, failure, failures, replay, facts, starved);
        }

        Played keptAs(Path file) {
            return new Played(number, seed, rotation, result, failure, failures, file, facts, starved);
        }
    }

    /** A series that plays games again which were lost on a starved machine. */
    public Series(Contest contest, long first, int seeds, boolean swap, Path folder, KeptReplays keep) {
        this(contest, first, seeds, swap, folder, keep, Hiccups.REPLAY);
    }

    /** A series with seeds in a row. */
    public Series(Contest contest, long first, int seeds, boolean swap, Path folder, KeptReplays keep,
                  Hiccups hiccups) {
        this(contest, Seeds.from(first), seeds, swap, folder, keep, hiccups);
    }

    /** Without a folder where nothing is to be kept. */
    @Internal
    public Series {
        folder = keep == KeptReplays.NONE ? null : folder;
    }

    /** The seed of the first game. */
    public long first() {
        return starts.at(0);
    }

    public int games() {
        return seeds * sides();
    }

    private int sides() {
        return swap || contest.isAlone() ? contest.entrants().size() : 1;
    }

    /** The seed of a game, counted from 1. */
    public long seed(int number) {
        return starts.at((number - 1) / sides());
    }

    /** By how many places the bots have moved up in a game, counted from 1. */
    public int rotation(int number) {
        return (number - 1) % sides();
    }

    /** The replay of a game, counted from 1; or {@code null}. */
    public Path file(int number) {
        return file(number, "");
    }

    /**
     * Returns where it goes if the game is played again because others used the processors; or {@code null}.
     *
     * @param attempt counted from 1
     */
    public Path starvedFile(int number, int attempt) {
        return file(number, "-starved" + (attempt == 1 ? "" : "-" + attempt));
    }

    private Path file(int number, String suffix) {
        if (folder == null) {
            return null;
        }
        String digits = Integer.toString(number);
        int width = Math.max(LEAST_DIGITS, Integer.toString(games()).length());
        return folder.resolve("game-" + "0".repeat(width - digits.length()) + digits + suffix + ".jsonl");
    }

    /** Checks that all replays can be written. */
    public void prepare(boolean overwrite) {
        if (folder == null) {
            return;
        }
        OutputFiles.prepareFolder(folder);
        for (int number = 1; number <= games() && !overwrite; number++) {
            for (Path file : List.of(file(number), starvedFile(number, 1), starvedFile(number, 2))) {
                if (Files.exists(file)) {
                    throw OutputFiles.exists(file);
                }
            }
        }
    }
}
