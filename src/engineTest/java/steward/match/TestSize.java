package steward.match;

/**
 * The size of a test that repeats something. One with the tag {@code sized} runs in {@code test} and again in
 * {@code campaigns}, larger.
 */
public final class TestSize {

    private static final boolean IS_CAMPAIGN = Boolean.getBoolean("steward.campaigns");

    private TestSize() {
    }

    /** The size in this JVM: the first in {@code test}, the second in {@code campaigns}. */
    public static int of(int inTest, int inCampaigns) {
        return IS_CAMPAIGN ? inCampaigns : inTest;
    }

    /** True in {@code campaigns}. */
    public static boolean isWhole() {
        return IS_CAMPAIGN;
    }
}
