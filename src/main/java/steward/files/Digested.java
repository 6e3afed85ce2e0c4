package steward.files;

/** Interface of content whose files decide what happens in a game; gives their digest. */
public interface Digested {

    /** Digest of the files, or {@code null} if there are none. */
    String digest();
}
