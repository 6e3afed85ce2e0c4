package steward.match;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import steward.bot.Answer;
import steward.bot.Player;

/**
 * A player that answers by a script and writes down, in a list it may share with others, what is done to it:
 * {@code A setup}, {@code A ask 1}, {@code A last}, {@code A end}, {@code A close}.
 */
class ScriptedPlayer implements Player {

    /** Answers of the script that begin so are faults with the rest as the reason. */
    static final String FAULT = "fault:";

    private final String name;
    private final List<String> log;
    private final IntFunction<String> script;
    private final List<Long> limits = new ArrayList<>();
    private Consumer<Answer> continuation;
    private int asked;
    private boolean over;

    /** @param script from the number of the question, counted from 1, to the answer */
    ScriptedPlayer(String name, List<String> log, IntFunction<String> script) {
        this.name = name;
        this.log = log;
        this.script = script;
    }

    /** One pod that stays where it is, without end. */
    static String idle(int question) {
        return "{\"pods\":[{\"x\":0,\"y\":0,\"thrust\":0}]}";
    }

    /** The limits it was asked with, in nanoseconds. */
    List<Long> limits() {
        return limits;
    }

    Consumer<Answer> continuation() {
        return continuation;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public void tell(byte[] lines, int length) {
        log.add(name + " setup");
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        log.add(name + " ask " + ++asked);
        limits.add(limitNanos);
        answer.clear();
        answer.setNanos(1000L * asked);
        answer.setExtraLines(asked == 2 ? 3 : 0);
        String said = script.apply(asked);
        if (said.startsWith(FAULT)) {
            answer.setFault(said.substring(FAULT.length()));
            return Ending.FAULT;
        }
        byte[] bytes = said.getBytes(StandardCharsets.UTF_8);
        answer.append(bytes, 0, bytes.length);
        return Ending.ANSWERED;
    }

    @Override
    public void onAbandoned(Consumer<Answer> goesOn) {
        continuation = goesOn;
    }

    @Override
    public void sendLastLines(byte[] lines, int length) {
        if (!over) {
            log.add(name + " last");
        }
    }

    @Override
    public void finish(byte[] lines, int length) {
        if (!over) {
            over = true;
            log.add(name + (lines == null ? " close" : " end"));
        }
    }
}
