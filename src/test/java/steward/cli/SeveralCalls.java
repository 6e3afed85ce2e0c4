package steward.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import steward.cli.streams.Streams;

/** Program that calls Steward several times in one JVM, and prints the status of each call. */
public final class SeveralCalls {

    private static final String END = ";";

    private SeveralCalls() { }

    /** The words that make these calls. */
    public static List<String> words(List<List<String>> calls) {
        return calls.stream().flatMap(call -> Stream.concat(call.stream(), Stream.of(END))).toList();
    }

    /** The line that says how a call ended. */
    public static String line(int status, List<String> call) {
        return "status " + status + " of " + call;
    }

    public static void main(String[] words) {
        List<String> call = new ArrayList<>();
        for (String word : words) {
            if (!word.equals(END)) {
                call.add(word);
                continue;
            }
            Streams streams = Streams.standard();
            int status = Main.run(streams, call.toArray(new String[0]));
            streams.out().println(line(status, call));
            streams.out().flush();
            call.clear();
        }
        System.exit(0);                                // as the program does: threads of a broker would go on a minute
    }
}
