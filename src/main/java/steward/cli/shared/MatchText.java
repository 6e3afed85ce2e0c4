package steward.cli.shared;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import steward.bot.command.CommandLine;
import steward.cli.streams.Colour;
import steward.contest.Failure;
import steward.guest.GuestType;
import steward.match.MatchResult;
import steward.match.MatchResult.PlayerResult;
import steward.text.TextFormat;

/** The result of a match as readable text. */
public final class MatchText {

    private MatchText() { }

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
            FailureText.line(result.players().get(failure.player()).name(), failure))).collect(Collectors.joining());
    }

    /** Prints everything about the result, and more about the players that failed. */
    public static void print(PrintStream out, Colour colour, String scene, long seed, MatchResult result,
                             List<Failure> failures) {
        out.println(colour.strong(headline(scene, seed, result)));
        out.println();
        table(out, result.players());
        for (int player = 0; player < result.players().size(); player++) {
            int number = player;
            note(out, colour, result.players().get(player),
                failures.stream().filter(each -> each.player() == number).findFirst().orElse(null));
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

    private static void table(PrintStream out, List<PlayerResult> players) {
        int width = players.stream().mapToInt(player -> player.name().length()).max().orElse(0);
        int names = Math.min(40, Math.max(4, width));
        out.println("player  " + TextFormat.left("bot", names) + "  rank   score   average ms   worst ms   first ms");
        for (int k = 0; k < players.size(); k++) {
            PlayerResult player = players.get(k);
            out.println(TextFormat.right(Integer.toString(k), 6) + "  "
                + TextFormat.left(TextFormat.plain(TextFormat.shorten(player.name(), names)), names)
                + TextFormat.right(Integer.toString(player.rank() + 1), 6)
                + TextFormat.right(TextFormat.number(player.score(), 2), 8)
                + TextFormat.right(ms(player.averageNanos()), 13)
                + TextFormat.right(ms(player.worstNanos()), 11)
                + TextFormat.right(ms(player.firstNanos()), 11));
        }
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
            FailureText.print(out, failure, "  ");
        }
        if (player.heldFrom() > 1) {                   // from turn 1 on only those are held that are to be in any case
            out.println(name + " was held from turn " + player.heldFrom() + ": it computed while others were asked");
        }
        if (player.earlyTurns() > 0) {
            out.println(colour.warning("warning:") + " " + name + " wrote more lines than it was asked for, in "
                + TextFormat.count(player.earlyTurns(), "turn") + "; they were taken for later answers");
        }
    }
}
