package steward.lab.bench;

import java.util.function.Consumer;

/** A part of the table. */
public interface Section {

    /** A word, for {@code --only}. */
    String name();

    /** Describes the measurement in one or two sentences for the page. */
    String about();

    /** Returns how often {@link #run} will report what is measured, approximately. */
    int steps(Effort effort);

    /** True if so few rounds are measured that ratios are not to be compared; notes of the rows say nothing of it. */
    default boolean isRough(Effort effort) {
        return false;
    }

    /**
     * Measures; each row is passed on as soon as it is known.
     *
     * @param about receives what is measured now
     * @throws Exception if something cannot be measured, with a readable message
     */
    void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception;
}
