package steward.replay.verify;

import steward.bot.Bot;
import steward.match.SeededBot;

/** A {@link SeededBot} that gives an unusable answer in one turn, and so is out. */
final class StoppingBot implements Bot {

    private final SeededBot bot;
    private final int last;
    private final String unusable;
    private int turns;

    /**
     * @param last     the turn of the unusable answer, counted from 1
     * @param ramming  how often it heads for an opponent, 0..1
     * @param unusable the answer of that turn
     */
    StoppingBot(int last, long seed, double ramming, String unusable) {
        this.last = last;
        this.unusable = unusable;
        bot = new SeededBot(seed, ramming);
    }

    @Override
    public void setup(String line) {
        bot.setup(line);
    }

    @Override
    public String turn(String line) {
        return ++turns < last ? bot.turn(line) : unusable;
    }
}
