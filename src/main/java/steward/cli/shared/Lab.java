package steward.cli.shared;

import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Unmatched;
import steward.files.InputException;

/** Commands and checks that the lab's jar offers; the program works without that jar. */
public interface Lab {

    /** Creates one of the lab's commands: stability, tradeoff or bench. */
    Object command(String name);

    /**
     * Plays made-up leagues and prints tables of how often bars and tests held.
     *
     * @param parts   of {@code docs/tables/rating.md}, in the order in which they are printed
     * @param leagues of each configuration
     * @param out     takes the lines, as soon as they are known
     */
    void selfCheck(List<String> parts, long leagues, int threads, Consumer<String> out) throws InterruptedException;

    static Optional<Lab> find() {
        return ServiceLoader.load(Lab.class).findFirst();
    }

    /**
     * Returns the lab.
     *
     * @param asked command or option that needs it
     * @throws InputException if its jar is not on the class path
     */
    static Lab of(String asked) {
        return find().orElseThrow(() -> new InputException(asked
            + ": found no lab, expected steward-lab.jar on the class path (an installation has it in lib)"));
    }

    /** Creates one of the lab's commands, or without the lab one in its place that only says so. */
    static Object commandOrMissing(String name) {
        return find().map(lab -> lab.command(name)).orElseGet(() -> new Missing(name));
    }

    /** Command of a lab that is not there. */
    @Command(description = "Comes with steward-lab.jar, which is missing.")
    final class Missing implements Callable<Integer> {

        private final String name;

        @Unmatched
        private List<String> words;

        private Missing(String name) {
            this.name = name;
        }

        @Override
        public Integer call() {
            of(name);
            throw new IllegalStateException(name);
        }
    }
}
