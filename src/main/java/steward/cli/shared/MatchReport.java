package steward.cli.shared;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.bot.command.CommandLine;
import steward.cli.streams.Colour;
import steward.contest.Contest;
import steward.contest.CountedGame;
import steward.contest.Failure;
import steward.guest.GuestType;
import steward.match.MatchResult;
import steward.match.MatchResult.PlayerResult;
import steward.match.OwnLimits;
import steward.report.Fields;
import steward.report.Table;
import steward.text.TextFormat;

/** Result of a match, as text for people and as JSON for programs. */
public final class MatchReport {

    private static final int LONGEST_NAME = 40;

    private MatchReport() { }

    /** One line: the winner, the ending, the turn; of a player alone, the score. */
    public static String headline(String scene, long seed, MatchResult result) {
        if (result.players().size() == 1) {
            MatchResult.PlayerResult alone = result.players().get(0);
            return TextFormat.plain(alone.name() + ": " + result.ending() + ", score "
                + TextFormat.number(alone.score(), 2) + ", " + TextFormat.count(result.turns(), "turn") + " (" + scene
                + ", seed " + seed + ")");
        }
        int winner = result.winner();
        String who = winner >= 0 ? result.players().get(winner).name() + " wins"
            : result.allFailed() ? "no winner and no draw of merit" : "a draw";
        return TextFormat.plain(who + ": " + ending(result) + ", " + TextFormat.count(result.turns(), "turn") + " ("
            + scene + ", seed " + seed + ")");
    }

    /** The ending in the game's words; with two players, "all others" is the other one. */
    private static String ending(MatchResult result) {
        boolean two = result.players().size() == 2;
        return !two ? result.ending() : switch (result.ending()) {
            case "all others are out" -> "the other player is out";
            case "all are out" -> result.allFailed() ? "both bots failed" : "both players are out";
            default -> result.ending();
        };
    }

    /**
     * Returns the headline as {@link #headline(String, long, MatchResult)} does, with the failures of bots on the same
     * line.
     */
    public static String headline(String scene, long seed, MatchResult result, List<Failure> failures) {
        return headline(scene, seed, result) + failures.stream().map(failure -> "; " + TextFormat.plain(
            FailureReason.line(result.players().get(failure.player()).name(), failure))).collect(Collectors.joining());
    }

    /** Prints everything about the result, and more about the players that failed. */
    public static void print(PrintStream out, Colour colour, String scene, long seed, MatchResult result,
                             List<Failure> failures) {
        out.println(colour.strong(headline(scene, seed, result)));
        out.println();
        table(result.players()).forEach(out::println);
        for (int player = 0; player < result.players().size(); player++) {
            note(out, colour, result.players().get(player), of(failures, player));
        }
    }

    /** Where the replay is, and what to do with it. @param game that was played */
    public static void printReplay(PrintStream out, Path file, String game) {
        String command = "  steward replay " + CommandLine.quote(List.of(file.toString()));
        out.println();
        out.println(TextFormat.plain("Replay: " + file));
        out.println(TextFormat.plain(command) + "            turn by turn");
        out.println(TextFormat.plain(command) + (game.equals(GuestType.ID) ? " --verify --run-referee" : " --verify")
            + "   plays it again and compares every turn");
    }

    private static List<String> table(List<PlayerResult> players) {
        return new Table<Integer>().right("player", 6, k -> Integer.toString(k))
            .left("bot ", 2, k -> TextFormat.plain(TextFormat.shorten(players.get(k).name(), LONGEST_NAME)))
            .right("rank", 6, k -> Integer.toString(players.get(k).rank() + 1))
            .right("score", 8, k -> TextFormat.number(players.get(k).score(), 2))
            .right("average ms", 13, k -> ms(players.get(k).averageNanos()))
            .right("worst ms", 11, k -> ms(players.get(k).worstNanos()))
            .right("first ms", 11, k -> ms(players.get(k).firstNanos()))
            .lines(IntStream.range(0, players.size()).boxed().toList());
    }

    /** Writes a time; 0 is none, as in an imported game. */
    private static String ms(long nanos) {
        return nanos == 0 ? "-" : TextFormat.ms(nanos);
    }

    private static void note(PrintStream out, Colour colour, PlayerResult player, Failure failure) {
        String name = TextFormat.plain(player.name());
        if (player.fault() != null) {
            out.println(name + " " + colour.bad("failed") + (failure == null ? "" : " in turn " + failure.turn()) + ": "
                + TextFormat.plain(player.fault()));
        } else if (player.out() != null) {
            out.println(name + " is out: " + TextFormat.plain(player.out()));
        }
        if (failure != null) {
            FailureReason.print(out, failure, "  ");
        }
        if (player.heldFrom() > 1) {                   // from turn 1 on only those are held that are to be in any case
            out.println(name + " was held from turn " + player.heldFrom() + ": it computed while others were asked");
        }
        if (player.earlyTurns() > 0) {
            out.println(colour.warning("warning:") + " " + name + " wrote more lines than it was asked for, in "
                + TextFormat.count(player.earlyTurns(), "turn") + "; they were taken for later answers");
        }
    }

    /** The result for programs. @param file of the replay, or {@code null} */
    public static Fields fields(Contest contest, long seed, CountedGame<?> game, Path file) {
        MatchResult result = game.result();
        return Fields.of("seed", Long.toString(seed), "scene", contest.sceneName(),
            "time", contest.time().basis().word(), "sandbox", contest.sandbox(), "turns", result.turns(),
            "ending", result.ending(), "winner", result.winner() < 0 ? null : result.winner(),
            "allFailed", result.allFailed(), "players", Fields.each(result.players().size(), k -> player(
                result.players().get(k), contest.entrants().get(k), of(game.failures(), k))),
            "data", result.data(), "playedAgain", game.again(), "replay", file);
    }

    private static Fields player(PlayerResult player, Contest.Entrant entrant, Failure failure) {
        return Fields.of("name", player.name(), "bot", entrant.bot(),
            OwnLimits.FIELD, OwnLimits.writtenOrNull(entrant.limits()), "rank", player.rank(),
            "score", player.score(), "out", player.out(), "fault", player.fault(),
            "failure", FailureReason.fields(failure),
            "answerMs", Fields.of("average", player.averageNanos() / TextFormat.NANOS_PER_MS,
                "worst", player.worstNanos() / TextFormat.NANOS_PER_MS,
                "first", player.firstNanos() / TextFormat.NANOS_PER_MS),
            "heldFrom", turnOrNull(player.heldFrom()), "warnings", player.earlyTurns() == 0 ? List.of()
                : List.of("lines beyond the answer in " + TextFormat.count(player.earlyTurns(), "turn")),
            "data", player.data());
    }

    /** The failure of a player, or {@code null}. */
    public static Failure of(List<Failure> failures, int player) {
        return failures.stream().filter(failure -> failure.player() == player).findFirst().orElse(null);
    }

    /** A turn counted from 1; {@code null} for 0. */
    public static Integer turnOrNull(int turn) {
        return turn == 0 ? null : turn;
    }
}
