package steward.bot;

/** Player whose program is missing or cannot be executed; it fails when it is asked for the first time. */
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
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        answer.setFault(fault);
        return Ending.FAULT;
    }
}
