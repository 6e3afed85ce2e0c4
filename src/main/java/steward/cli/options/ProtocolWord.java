package steward.cli.options;

import java.util.Arrays;
import java.util.Iterator;
import steward.match.Protocol;
import steward.text.NearestName;

/** Values of {@code --protocol}. */
public final class ProtocolWord {

    /** The names of all protocols. */
    public static final class Candidates implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Arrays.stream(Protocol.values()).map(Protocol::word).iterator();
        }
    }

    private ProtocolWord() { }

    /** The protocol of that name; the call is refused if there is none. */
    public static Protocol parse(String word) {
        CallCheck.withHelp().that(Protocol.of(word).isPresent(),
            "--protocol: found '" + word + "', expected json or codingame"
                + NearestName.question(word, Arrays.stream(Protocol.values()).map(Protocol::word).toList(), "'"));
        return Protocol.of(word).orElseThrow();
    }
}
