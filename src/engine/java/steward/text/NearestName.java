package steward.text;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/**
 * Known word that a misspelt one was probably meant to be. It has the fewest insertions, deletions, replacements and
 * swaps of adjacent letters (the restricted edit distance of Damerau and Levenshtein), ignoring case.
 */
public final class NearestName {

    private NearestName() { }

    /**
     * @param word  as written
     * @param known the known words; of equally near ones the first in iteration order wins
     * @return the nearest word, if at most a third of the letters change (one change is always allowed, if at least one
     *     letter stays)
     */
    public static Optional<String> of(String word, Collection<String> known) {
        String best = null;
        int bestDistance = Integer.MAX_VALUE;
        for (String candidate : known) {
            int distance = distance(word.toLowerCase(Locale.ROOT), candidate.toLowerCase(Locale.ROOT));
            int length = Math.max(word.length(), candidate.length());
            if (distance < bestDistance && distance <= Math.max(1, length / 3) && distance < length) {
                best = candidate;
                bestDistance = distance;
            }
        }
        return Optional.ofNullable(best);
    }

    /**
     * Ends a message about an unknown word.
     *
     * @param quote before and behind the nearest word; may be empty
     * @return the question whether that was meant, with a semicolon before it; empty if none is near
     */
    public static String question(String word, Collection<String> known, String quote) {
        return of(word, known).map(near -> "; did you mean " + quote + near + quote + "?").orElse("");
    }

    /** Dynamic programming over the prefixes of both words, row by row; a swap refers to the row before the last. */
    private static int distance(String a, String b) {
        int[] beforeLast = new int[b.length() + 1];
        int[] last = new int[b.length() + 1];
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int[] free = beforeLast;
            beforeLast = last;
            last = row;
            row = free;
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = last[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                row[j] = Math.min(replaced, 1 + Math.min(last[j], row[j - 1]));
                boolean swapped = i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2)
                    && a.charAt(i - 2) == b.charAt(j - 1);
                if (swapped) {
                    row[j] = Math.min(row[j], beforeLast[j - 2] + 1);
                }
            }
        }
        return row[b.length()];
    }
}
