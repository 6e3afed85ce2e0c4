package steward.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.bot.AlteredBot;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.cli.shared.Games;
import steward.game.GameSetup;
import steward.match.MatchResult;

/**
 * A match of in-process bots with its replay.
 *
 * @param bytes  the replay
 * @param sent   per player the lines it was sent, each with its line end
 * @param result how it ended
 */
public record Recorded(byte[] bytes, List<String> sent, MatchResult result) {

    private static final Pattern CHECKPOINT = Pattern.compile("\\{\"x\":(\\d+),\"y\":(\\d+)\\}");

    /** Drives from checkpoint to checkpoint with one pod, or only stands. */
    private static final class Pilot implements Bot {

        private final int thrust;
        private final List<String> checkpoints = new ArrayList<>();
        private int player;
        private int turn;

        Pilot(int thrust) {
            this.thrust = thrust;
        }

        @Override
        public void setup(String line) {
            CHECKPOINT.matcher(line).results().forEach(checkpoint ->
                checkpoints.add("\"x\":" + checkpoint.group(1) + ",\"y\":" + checkpoint.group(2)));
            player = number(line, "\"player\":(\\d+)");
        }

        @Override
        public String turn(String line) {
            int next = number(line, "\"player\":" + player + ",.*?\"nextCheckpoint\":(\\d+)");
            return "{\"pods\":[{" + checkpoints.get(next) + ",\"thrust\":" + thrust + "}],\"message\":\"t" + ++turn
                + "\"}";
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
        List<AlteredBot> bots = new ArrayList<>();
        List<InProcessPlayer> players = new ArrayList<>();
        for (char way : ways.toCharArray()) {
            AlteredBot bot = new AlteredBot(new Pilot(way == 's' ? 0 : 120), way == 'f' ? failing : 0,
                answer -> "nonsense");
            players.add(new InProcessPlayer("pilot-" + bots.size(), bot));
            bots.add(bot);
        }
        steward.replay.Recorded played = steward.replay.Recorded.ofPlayers(setup, seed, players,
            players.stream().map(InProcessPlayer::name).toList());
        return new Recorded(played.bytes(), bots.stream().map(bot -> String.join("\n", bot.sent()) + "\n").toList(),
            played.result());
    }
}
