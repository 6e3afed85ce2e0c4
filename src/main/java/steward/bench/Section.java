package steward.bench;

import java.util.function.Consumer;

/** A part of the table. */
public interface Section {

    /** A word, for {@code --only}. */
    String name();

    /** What is measured and how, in one or two sentences for the page. */
    String about();

    /** How often {@link #run} will tell what is measured, about. */
    int steps(Effort effort);

    /**
     * Measures; each line is handed over as soon as it is known.
     *
     * @param about is told what is measured now
     * @throws Exception if something cannot be measured, with words for people
     */
    void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception;
}
