package steward.cli.options;

import steward.match.Protocol;

/** What {@code --protocol} takes. */
public final class ProtocolWord {

    private ProtocolWord() {
    }

    /** The protocol of that name; the call is refused if there is none. */
    public static Protocol parse(String word) {
        CallCheck.withHelp().that(Protocol.of(word).isPresent(),
            "--protocol: found '" + word + "', expected json or codingame");
        return Protocol.of(word).orElseThrow();
    }
}
