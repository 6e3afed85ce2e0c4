package steward.files;

/** Contents of files that decide what happens in a game. */
public interface Digested {

    /** Digest of the files, or {@code null} if there are none. */
    String digest();
}
