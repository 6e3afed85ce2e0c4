package steward.codingame;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.bot.Player;
import steward.bot.StderrPlayer;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;

/** A bot of the upper leagues within this JVM: it speaks text, heads for its checkpoints and says which turn it is. */
final class TextPilot implements Bot {

    static final String NONSENSE = "nonsense";

    private final int fails;
    private final List<String[]> checkpoints = new ArrayList<>();
    private int turn;

    /** @param fails the turn in which it answers nonsense, or 0 */
    TextPilot(int fails) {
        this.fails = fails;
    }

    @Override
    public void setup(String lines) {
        lines.lines().skip(2).forEach(line -> checkpoints.add(line.split(" ")));
    }

    @Override
    public String turn(String lines) {
        turn++;
        if (turn == fails) {
            return NONSENSE + "\n" + NONSENSE;
        }
        return answer(lines, 0) + "\n" + answer(lines, 1);
    }

    private String answer(String lines, int pod) {
        String[] next = checkpoints.get(Integer.parseInt(lines.split("\n")[pod].split(" ")[5]));
        return next[0] + " " + next[1] + " 100 turn " + turn;
    }

    /**
     * Plays a match.
     *
     * @param stderr what the first player writes there, by turn
     * @param fails  per player, the turn in which it answers nonsense, or 0
     */
    static MatchResult play(GameSetup setup, MatchListener listener, IntFunction<String> stderr, int... fails)
            throws InterruptedException {
        List<Seat> seats = new ArrayList<>();
        for (int player = 0; player < fails.length; player++) {
            Player pilot = new InProcessPlayer("pilot-" + player, new TextPilot(fails[player]));
            seats.add(new Seat(player == 0 ? new StderrPlayer(pilot, stderr) : pilot, Protocol.CODINGAME));
        }
        return Referee.of(setup, 7, seats, TimeControl.UNLIMITED, listener).play();
    }
}
