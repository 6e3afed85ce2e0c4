package steward.cli.play;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import steward.cli.options.BuiltinBotWords;
import steward.files.InputException;
import steward.text.TextFormat;

/**
 * Arguments that callers of other referees pass: players as {@code -p1} to {@code -p8}, a seed in one of three ways.
 *
 * @param spec the options of the players are there
 */
record RefereeArguments(CommandSpec spec) {

    static final int MOST_PLAYERS = 8;

    private static final String SEED = "seed";

    /** Adds {@code -p1}, {@code -p1name}, {@code -p2}, ... to a command. */
    static void addPlayers(CommandSpec spec) {
        for (int player = 1; player <= MOST_PLAYERS; player++) {
            boolean shown = player <= 2;
            spec.addOption(OptionSpec.builder(bot(player)).type(String.class).paramLabel("BOT").hidden(!shown)
                .completionCandidates(new BuiltinBotWords())
                .description(shown ? "Player " + player + ": a bot, see below; there is -p1 to -p8." : "").build());
            spec.addOption(OptionSpec.builder(name(player)).type(String.class).paramLabel("NAME").hidden(player > 1)
                .description(player == 1 ? "The name of player 1; likewise -p2name, ..." : "").build());
        }
    }

    private static String bot(int player) {
        return "-p" + player;
    }

    private static String name(int player) {
        return bot(player) + "name";
    }

    private String value(String option) {
        return spec.findOption(option).getValue();
    }

    /** True if a word of a call names a player. */
    static boolean isPlayer(String word) {
        return word.matches("-p[1-" + MOST_PLAYERS + "](=.*)?");
    }

    /** Number of players: those that are named from the first on without a gap. */
    int players() {
        return (int) IntStream.rangeClosed(1, MOST_PLAYERS).takeWhile(player -> value(bot(player)) != null).count();
    }

    /**
     * The bots in order.
     *
     * @param players how many there must be
     */
    List<String> bots(int players, String scene) {
        List<String> bots = new ArrayList<>();
        for (int player = 1; player <= MOST_PLAYERS; player++) {
            String bot = value(bot(player));
            if ((bot != null) != player <= players) {
                throw new InputException((bot == null ? "found no " : "found ") + bot(player) + ", expected -p1"
                    + (players == 1 ? " alone" : " to -p" + players) + ": the scene \"" + scene + "\" is for "
                    + TextFormat.count(players, "player")
                    + (players == 1 && bot != null ? ", and there are no seats to "
                        + "change; 'steward match --games' plays each of several bots alone on the same maps" : ""));
            }
            if (bot == null && value(name(player)) != null) {
                throw new InputException("found " + name(player) + ", expected " + bot(player) + " with it");
            }
            if (bot != null) {
                bots.add(bot);
            }
        }
        return bots;
    }

    /** Returns the name that a player, counted from 0, is given, or {@code null}. */
    String nameOf(int player) {
        return value(name(player + 1));
    }

    /**
     * The seed in lines of {@code key=value}, or {@code null}; other keys are for other games.
     *
     * @throws InputException if a line or the seed is wrong
     */
    static Long seed(List<String> data) {
        Long seed = null;
        for (String line : String.join("\n", data).split("\\R")) {
            int equals = line.indexOf('=');
            if (equals < 0 && !line.isBlank()) {
                throw new InputException("-d: found '" + line + "', expected key=value, such as seed=7");
            }
            if (equals >= 0 && line.substring(0, equals).strip().equals(SEED)) {
                try {
                    seed = Long.valueOf(line.substring(equals + 1).strip());
                } catch (NumberFormatException problem) {
                    throw new InputException("-d: found '" + line
                        + "', expected a whole number of 64 bits after seed=");
                }
            }
        }
        return seed;
    }
}
