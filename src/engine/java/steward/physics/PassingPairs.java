package steward.physics;

import java.util.Arrays;

/**
 * Pairs that pass through each other until they separate, because a {@link Reaction} answered {@code PASS}. Usually
 * empty; a short unsorted list of packed ids.
 */
public final class PassingPairs {

    private long[] pairs = new long[8];
    private int size;

    public boolean isEmpty() {
        return size == 0;
    }

    public int size() {
        return size;
    }

    /** True if the body with id {@code a} passes that with id {@code b}, or the wall {@code ~b} if b is negative. */
    public boolean contains(int a, int b) {
        long pair = pack(a, b);
        for (int k = 0; k < size; k++) {
            if (pairs[k] == pair) {
                return true;
            }
        }
        return false;
    }

    public void add(int a, int b) {
        if (size == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * size);
        }
        pairs[size++] = pack(a, b);
    }

    /** First id of the k-th pair: always a body. */
    public int first(int k) {
        return (int) (pairs[k] >> 32);
    }

    /** Second id of the k-th pair: a body, or {@code ~wall}. */
    public int second(int k) {
        return (int) pairs[k];
    }

    /** Removes the k-th pair; the last one takes its place. */
    public void remove(int k) {
        pairs[k] = pairs[--size];
    }

    void copyFrom(PassingPairs other) {
        if (pairs.length < other.size) {
            pairs = new long[other.pairs.length];
        }
        System.arraycopy(other.pairs, 0, pairs, 0, other.size);
        size = other.size;
    }

    private static long pack(int a, int b) {
        int first = b < 0 ? a : Math.min(a, b);
        int second = b < 0 ? b : Math.max(a, b);
        return (long) first << 32 | second & 0xFFFFFFFFL;
    }
}
