package steward.lab.bench;

import java.util.function.Consumer;

/** Section of the bench's table: its title and its comparisons. */
public interface Section {

    /** A word, for {@code --only}. */
    String name();

    /** Describes the measurement in one or two sentences for the page. */
    String about();

    /** Returns how many steps of progress {@link #run} makes, approximately. */
    int steps(Effort effort);

    /**
     * Measures; each row is passed on as soon as it is known.
     *
     * @param step called after each step
     * @throws Exception if something cannot be measured, with a readable message
     */
    void run(Effort effort, Runnable step, Consumer<Row> rows) throws Exception;
}
