package steward.schema;

import java.util.ArrayList;
import java.util.List;
import steward.bot.Bot;
import steward.match.SeededBot;

/** Bot of random commands that keeps the frames that it gets and the answers that it gives. */
final class HeardBot implements Bot {

    private final SeededBot bot;
    private final int last;
    private final List<String> lines = new ArrayList<>();

    /** @param last number of lines after which it says something unusable, which is not kept */
    HeardBot(SeededBot bot, int last) {
        this.bot = bot;
        this.last = last;
    }

    List<String> lines() {
        return lines;
    }

    @Override
    public void setup(String line) {
        lines.add(line);
        bot.setup(line);
    }

    @Override
    public String turn(String line) {
        lines.add(line);
        if (lines.size() > last) {
            return "thrust!";
        }
        String answer = bot.turn(line);
        lines.add(answer);
        return answer;
    }

    @Override
    public void end(String line) {
        lines.add(line);
    }
}
