package steward.cli;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.bot.Player;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;

/**
 * A match of in-process bots with its replay.
 *
 * @param bytes  the replay
 * @param sent   per player the lines it was sent, each with its line end
 * @param result how it ended
 */
public record Recorded(byte[] bytes, List<StringBuilder> sent, MatchResult result) {

    private static final Pattern CHECKPOINT = Pattern.compile("\\{\"x\":(\\d+),\"y\":(\\d+)\\}");

    /** Drives from checkpoint to checkpoint with one pod, or only stands. */
    private static final class Pilot implements Bot {

        private final StringBuilder sent;
        private final boolean standing;
        private final int failing;
        private final List<String> checkpoints = new ArrayList<>();
        private int player;
        private int turn;

        Pilot(StringBuilder sent, boolean standing, int failing) {
            this.sent = sent;
            this.standing = standing;
            this.failing = failing;
        }

        @Override
        public void setup(String line) {
            sent.append(line).append('\n');
            Matcher checkpoint = CHECKPOINT.matcher(line);
            while (checkpoint.find()) {
                checkpoints.add("\"x\":" + checkpoint.group(1) + ",\"y\":" + checkpoint.group(2));
            }
            player = number(line, "\"player\":(\\d+)");
        }

        @Override
        public String turn(String line) {
            sent.append(line).append('\n');
            if (++turn == failing) {
                return "nonsense";
            }
            int next = number(line, "\"player\":" + player + ",.*?\"nextCheckpoint\":(\\d+)");
            return "{\"pods\":[{" + checkpoints.get(next) + ",\"thrust\":" + (standing ? 0 : 120) + "}],\"message\":\"t"
                + turn + "\"}";
        }

        @Override
        public void end(String line) {
            sent.append(line).append('\n');
        }

        private static int number(String line, String pattern) {
            Matcher matcher = Pattern.compile(pattern).matcher(line);
            if (!matcher.find()) {
                throw new AssertionError(pattern + " in " + line);
            }
            return Integer.parseInt(matcher.group(1));
        }
    }

    /** Two bots that both drive well. */
    public static Recorded duel(long seed) {
        return play(Games.open("duel"), seed, "dd", 0);
    }

    /**
     * @param ways    per player {@code d} to drive, {@code s} to stand, {@code f} to drive and fail
     * @param failing the turn of the failure
     */
    public static Recorded play(GameSetup setup, long seed, String ways, int failing) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        List<StringBuilder> sent = new ArrayList<>();
        List<Player> players = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (int k = 0; k < ways.length(); k++) {
            sent.add(new StringBuilder());
            names.add("pilot-" + k);
            players.add(new InProcessPlayer(names.get(k),
                new Pilot(sent.get(k), ways.charAt(k) == 's', ways.charAt(k) == 'f' ? failing : 0)));
        }
        ReplayWriter writer = new ReplayWriter(file, new ReplayHeader(setup.scene().gameId(), setup.scene().json(),
            seed, names, names, Double.POSITIVE_INFINITY).ofLaw(setup.plan().lawVersion()));
        try {
            MatchResult result = new Referee(setup, seed, players, TimeControl.UNLIMITED, writer).play();
            return new Recorded(file.toByteArray(), sent, result);
        } catch (InterruptedException problem) {
            throw new AssertionError(problem);
        }
    }
}
