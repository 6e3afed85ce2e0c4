package steward.cli.shared;

import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Unmatched;
import steward.files.InputException;

/** Service through which the lab's jar offers its commands; the program works without that jar. */
public interface Lab {

    /** Creates one of the lab's commands: tradeoff or bench. */
    Object command(String name);

    static Optional<Lab> find() {
        return ServiceLoader.load(Lab.class).findFirst();
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
            throw new InputException(name
                + ": found no lab, expected steward-lab.jar on the class path (an installation has it in lib)");
        }
    }
}
