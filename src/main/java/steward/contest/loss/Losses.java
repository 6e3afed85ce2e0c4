package steward.contest.loss;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.report.Fields;
import steward.report.MeanValue;
import steward.report.Table;
import steward.text.TextFormat;

/**
 * Account of the games that one bot lost. It has how they ended, from which turn the bot was behind to the end, the
 * worst game of each kind, and the bot's values in won and lost games side by side. The worst game has the greatest
 * distance to the winner's score; among equals, the shortest. Not thread-safe.
 */
public final class Losses {

    /** Kinds and values that are listed: with them the account fits a screen. */
    private static final int KINDS = 5;
    private static final int VALUES = 8;
    private static final int LONGEST = 60;
    private static final int NAME = 18;
    private static final int COLUMN = 22;

    private final String bot;
    private final Map<String, List<Game>> kinds = new TreeMap<>();
    private final Map<String, MeanValue> won = new TreeMap<>();
    private final Map<String, MeanValue> lost = new TreeMap<>();
    private int wins;
    private int draws;
    private int losses;
    private final boolean lower;
    private int skipped;
    private int skippedWon;
    private int repeats;

    /** Result of a game for the bot. */
    public enum Outcome {
        WON, DRAWN, LOST;

        /** Returns that of a player. @param sharers players on the first rank */
        public static Outcome of(int rank, long sharers) {
            return rank > 0 ? LOST : sharers > 1 ? DRAWN : WON;
        }
    }

    /**
     * A game of the bot.
     *
     * @param name       as it is listed, such as {@code game 7 (seed 12)}
     * @param kind       how it ended for the bot
     * @param turns      that were played
     * @param behindFrom the turn from which on another was ahead to the end; {@link LeadLog#UNKNOWN} if not known
     * @param score      of the bot
     * @param winner     the score of who won, if that was another bot
     * @param values     of the bot, by name
     * @param replay     where it is, or {@code null}
     */
    public record Game(String name, Outcome outcome, String kind, int turns, int behindFrom, double score,
                       double winner, Map<String, Double> values, String replay) { }

    /** None yet of a bot. @param lower whether a lower score is better */
    public Losses(String bot, boolean lower) {
        this.bot = bot;
        this.lower = lower;
    }

    /** Returns how a game ended for a player: its failure, why it is out, or how the game ended. */
    public static String kind(String fault, String out, String ending) {
        return fault != null ? "failed: " + fault : out != null ? "out: " + out : ending == null ? "not known" : ending;
    }

    /** Adds a game. */
    public void add(Game game) {
        switch (game.outcome()) {
            case WON -> wins++;
            case DRAWN -> draws++;
            default -> {
                losses++;
                kinds.computeIfAbsent(game.kind(), kind -> new ArrayList<>()).add(game);
            }
        }
        if (game.outcome() != Outcome.DRAWN) {
            Map<String, MeanValue> means = game.outcome() == Outcome.WON ? won : lost;
            add(means, "score", game.score());
            add(means, "turns", game.turns());
            game.values().forEach((name, value) -> add(means, name, value));
        }
    }

    private static void add(Map<String, MeanValue> means, String name, double value) {
        if (Double.isFinite(value)) {
            means.computeIfAbsent(name, any -> new MeanValue()).add(value);
        }
    }

    /** Notes that no replay of a game was read: how it was lost, or what bots reported in it, is not known. */
    public void skip(boolean isLost) {
        skipped += isLost ? 1 : 0;
        skippedWon += isLost ? 0 : 1;
    }

    /** Notes a game that only repeats another, and is left out. */
    public void repeat() {
        repeats++;
    }

    /** Number of lost games. */
    public int losses() {
        return losses;
    }

    private List<List<Game>> byNumber() {
        return kinds.values().stream().sorted(Comparator.comparing((List<Game> games) -> -games.size())).toList();
    }

    private Game worst(List<Game> games) {
        return games.stream().min(Comparator.comparingDouble((Game game) -> lower ? game.winner() - game.score()
            : game.score() - game.winner()).thenComparingInt(Game::turns)).orElseThrow();
    }

    private static int[] behind(List<Game> games) {
        return games.stream().mapToInt(Game::behindFrom).filter(turn -> turn != LeadLog.UNKNOWN).sorted().toArray();
    }

    private List<String> names() {
        List<String> names = new ArrayList<>(List.of("score", "turns"));
        lost.keySet().stream().filter(name -> !names.contains(name)).forEach(names::add);
        won.keySet().stream().filter(name -> !names.contains(name)).forEach(names::add);
        return names.stream().filter(name -> lost.containsKey(name) || won.containsKey(name)).toList();
    }

    /** Returns the account, lines of a screen. */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add(TextFormat.plain(bot) + " lost " + losses + " of " + TextFormat.count(wins + draws + losses, "game")
            + ", drew " + draws + ", won " + wins + (repeats == 0 ? "" : "; " + TextFormat.count(repeats, "other")
            + " only " + (repeats == 1 ? "repeats" : "repeat") + " games") + (losses == 0 ? "" : ":"));
        if (losses == 0) {
            return lines;
        }
        lines.add("  lost   behind for good from turn   how it ended");
        List<List<Game>> all = byNumber();
        for (List<Game> games : all.subList(0, Math.min(KINDS, all.size()))) {
            Game worst = worst(games);
            lines.add(TextFormat.right(Integer.toString(games.size()), 6) + "   " + TextFormat.left(text(behind(games)),
                25) + "   " + TextFormat.plain(TextFormat.shorten(worst.kind(), LONGEST)));
            lines.add("         worst: " + worst.name() + ", " + TextFormat.count(worst.turns(), "turn") + ", score "
                + TextFormat.number(worst.score(), 2) + " to " + TextFormat.number(worst.winner(), 2)
                + (worst.behindFrom() == LeadLog.UNKNOWN ? "" : ", behind from turn " + worst.behindFrom())
                + (worst.replay() == null ? "" : ", replay " + TextFormat.plain(worst.replay())));
        }
        if (all.size() > KINDS) {
            lines.add("         and " + TextFormat.count(all.size() - KINDS, "kind") + " more");
        }
        if (skipped > 0) {
            lines.add("  Of " + TextFormat.count(skipped, "lost game") + " no replay was read: nobody knows how they "
                + "ended.");
        }
        if (skippedWon > 0) {
            lines.add("  Of " + TextFormat.count(skippedWon, "won game") + " no replay was read: what bots reported in "
                + "them is not known.");
        }
        lines.addAll(values().lines(names().stream().limit(VALUES).toList()));
        return lines;
    }

    /** Median and range. */
    private static String text(int... sorted) {
        return sorted.length == 0 ? "not known" : sorted.length == 1 ? Integer.toString(sorted[0])
            : "median " + sorted[sorted.length / 2] + " (" + sorted[0] + " to " + sorted[sorted.length - 1] + ")";
    }

    /** The account for programs. */
    public Fields fields() {
        return Fields.of("bot", bot, "won", wins, "drawn", draws, "lost", losses, "unread", skipped,
            "unreadWon", skippedWon, "repeats", repeats, "kinds", Fields.each(byNumber(), games -> {
                Game worst = worst(games);
                int[] turns = behind(games);
                return Fields.of("kind", worst.kind(), "games", games.size(),
                    "behindFromMedian", turns.length == 0 ? null : turns[turns.length / 2], "worst", worst.name(),
                    "turns", worst.turns(), "behindFrom", worst.behindFrom() == LeadLog.UNKNOWN ? null
                    : worst.behindFrom(), "score", worst.score(), "winner", worst.winner(), "replay", worst.replay());
            }), "values", values().json(names()));
    }

    private Table<String> values() {
        return new Table<String>().value("name", name -> name)
            .left("value" + " ".repeat(NAME - "value".length()), 0, name -> TextFormat.plain(TextFormat.shorten(name,
                NAME)))
            .value("lostMean", name -> mean(lost, name).mean())
            .value("lostDeviation", name -> mean(lost, name).deviation())
            .right("in " + TextFormat.count(losses, "lost game"), COLUMN, name -> mean(lost, name).text())
            .value("wonMean", name -> mean(won, name).mean())
            .value("wonDeviation", name -> mean(won, name).deviation())
            .right("in " + TextFormat.count(wins, "won game"), COLUMN, name -> mean(won, name).text());
    }

    private static MeanValue mean(Map<String, MeanValue> means, String name) {
        return means.getOrDefault(name, new MeanValue());
    }
}
