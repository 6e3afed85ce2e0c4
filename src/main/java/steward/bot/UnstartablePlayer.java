package steward.bot;

import java.util.function.Consumer;

/** A player whose program is not there, or cannot be executed: it fails when it is asked for the first time. */
public final class UnstartablePlayer implements Player {

    private final String name;
    private final String fault;

    /** @param problem why it cannot be started */
    public UnstartablePlayer(String name, String problem) {
        this.name = name;
        fault = "could not be started: " + problem;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public void tell(byte[] lines, int length) {
        // There is no process to send them to.
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        answer.setFault(fault);
        return Ending.FAULT;
    }

    @Override
    public void onAbandoned(Consumer<Answer> continuation) {
        // The call always returns.
    }

    @Override
    public void finish(byte[] lines, int length) {
        // Nothing to end.
    }
}
