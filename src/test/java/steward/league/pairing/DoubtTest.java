package steward.league.pairing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import steward.league.rating.RatingFit;
import steward.league.rating.Ratings;
import steward.league.rating.Stratum;

/** Pairs that are in doubt, and the games that follow from it. Games of two, two of a seed. */
class DoubtTest {

    private static final StopRule RULE = new StopRule(Double.NaN, true, StopRule.USUAL_EQUAL);

    /** Clusters of two bots, by how many of its two games the first has won. */
    private static Stratum met(int one, int other, long lost, long shared, long won) {
        Stratum stratum = new Stratum(1, one, other);
        stratum.add(stratum.pattern(2, 0, 0), lost);
        stratum.add(stratum.pattern(2, 1, 0), shared);
        stratum.add(stratum.pattern(2, 2, 0), won);
        return stratum;
    }

    private static Ratings ratings(int bots, Stratum... strata) {
        return new Ratings(IntStream.range(0, bots).boxed().toList(), RatingFit.of(bots, List.of(strata), false));
    }

    /** Counts how often each group plays in so many decisions. */
    private static Map<List<Integer>, Integer> count(Map<List<Integer>, Integer> games, AdaptivePairing pairing,
                                                     int decisions) {
        for (int decision = 0; decision < decisions; decision++) {
            pairing.next(decision);
            int[] group = pairing.choose(any -> true);
            pairing.made(1, group);
            games.merge(Arrays.stream(group).boxed().toList(), 1, Integer::sum);
        }
        return games;
    }

    @Test
    void whoHappensToStandInTheMiddleDoesNotPlayMore() {
        // All three are in doubt, whoever is ahead by chance: they play a round robin. If only neighbours in the table
        // counted, the first and the last would meet half as often, and those who were lucky would stay so.
        Ratings found = ratings(3, met(0, 1, 9, 20, 11), met(0, 2, 8, 20, 12), met(1, 2, 9, 20, 11));
        assertEquals(List.of(0, 1, 2), found.order());
        AdaptivePairing pairing = new AdaptivePairing(found.versions(), 2, 4, RULE, decision -> found);
        Map<List<Integer>, Integer> games = count(new HashMap<>(), pairing, 300);
        games.values().forEach(each -> assertEquals(100, each, 5, games::toString));
    }

    /** A group without games has no weight in the fit, and nothing that doubt could lose: it once never played. */
    @Test
    void everyGroupOfThreePlays() {
        Map<List<Integer>, Integer> games = new HashMap<>();
        AdaptivePairing pairing = new AdaptivePairing(IntStream.range(0, 10).boxed().toList(), 3, 4, RULE,
            decision -> ratings(10, games.keySet().stream().map(DoubtTest::three).toArray(Stratum[]::new)));
        assertEquals(120, count(games, pairing, 200).size());
    }

    /** Three of which each has beaten the others as often. */
    private static Stratum three(List<Integer> bots) {
        Stratum stratum = new Stratum(2.0 / 3, bots.get(0), bots.get(1), bots.get(2));
        stratum.add(stratum.pattern(1, 1, 0, 1, 1, 0, 1, 1, 0), 20);
        stratum.add(stratum.pattern(1, 0, 0, 1, 0, 0, 1, 0, 0), 20);
        return stratum;
    }

    /** Two of a gauntlet win all their games and never meet: 1/2^n is below the permitted errors for n = 40, not 4. */
    @Test
    void whoCannotMeetIsWaitedForUntilItsOwnGamesAreSure() {
        BiPredicate<Integer, Integer> gauntlet = (one, other) -> one == 2 || other == 2;
        Ratings few = ratings(3, met(0, 2, 0, 0, 4), met(1, 2, 0, 0, 40));
        assertFalse(RULE.isMet(few, gauntlet));
        Ratings found = ratings(3, met(0, 2, 0, 0, 40), met(1, 2, 0, 0, 40));
        assertEquals(List.of(StopRule.Order.APART, StopRule.Order.ORDERED),
            RULE.orders(found, found.order(), gauntlet));
        assertTrue(RULE.isMet(found, gauntlet));
        Ratings before = ratings(3, met(0, 1, 0, 0, 40), met(0, 2, 0, 0, 40), met(1, 2, 0, 0, 40));
        assertEquals(List.of(StopRule.Order.ORDERED, StopRule.Order.ORDERED), RULE.orders(before, before.order(),
            gauntlet), "they met before it was one");
        assertFalse(RULE.isMet(found, (one, other) -> true), "where they can meet they will");
    }

    /** Of two groups no bot can meet one of the other: 0 beats 1, 2 beats 3, with three points of four. */
    @Test
    void groupsThatCannotMeetAreRankedEachForItself() {
        BiPredicate<Integer, Integer> within = (one, other) -> one / 2 == other / 2;
        Ratings half = ratings(4, met(0, 1, 0, 300, 300), met(2, 3, 1, 2, 3));
        assertFalse(RULE.isMet(half, within));
        Ratings found = ratings(4, met(0, 1, 0, 300, 300), met(2, 3, 0, 300, 300));
        assertEquals(List.of(StopRule.Order.ORDERED, StopRule.Order.APART, StopRule.Order.ORDERED),
            RULE.orders(found, found.order(), within));
        assertTrue(RULE.isMet(found, within));
        assertFalse(RULE.isMet(found, (one, other) -> true));
    }

    @Test
    void whatIsSettledGoesOnCountingHalf() {
        // Bots 0 and 1 are in doubt, bot 2 is surely below both. A variance c/n falls by c/(n (n + 1)) with one more,
        // so that n grows as the root of c: one of doubt and two of half of it, as shares of their variances.
        Ratings found = ratings(3, met(0, 1, 100, 200, 101), met(0, 2, 20, 160, 220), met(1, 2, 21, 160, 219));
        assertEquals(StopRule.Order.OPEN, RULE.order(found, 0, 1));
        assertEquals(StopRule.Order.ORDERED, RULE.order(found, 0, 2));
        assertEquals(StopRule.Order.ORDERED, RULE.order(found, 1, 2));
        Map<List<Integer>, Double> doubt = found.parts(List.of(new int[] {0, 1}));
        Map<List<Integer>, Double> rest = found.parts(List.of(new int[] {0, 2}, new int[] {1, 2}));
        double roots = doubt.keySet().stream().mapToDouble(key -> Math.sqrt(doubt.get(key) + rest.get(key) / 4)).sum();
        AdaptivePairing pairing = new AdaptivePairing(found.versions(), 2, 4, RULE, decision -> found);
        Map<List<Integer>, Integer> games = count(new HashMap<>(), pairing, 3000);
        doubt.forEach((key, part) -> assertEquals(Math.sqrt(part + rest.get(key) / 4) / roots * 3000, games.get(key),
            10, games::toString));
        assertTrue(games.get(List.of(0, 1)) > 1.2 * games.get(List.of(0, 2)), games::toString);
    }

    @Test
    void clustersThatHappenToBeAlikeDoNotSeemSure() {
        // All are equal. Bots 0 and 1 have shared all of their seeds, 0 and 2 none: to the order of 0 and 1 the games
        // of 0 and 2 tell as much as those of 1 and 2, which went as games go.
        Ratings found = ratings(3, met(0, 1, 0, 40, 0), met(0, 2, 20, 0, 20), met(1, 2, 10, 20, 10));
        Map<List<Integer>, Double> parts = found.parts(List.of(new int[] {0, 1}));
        assertEquals(parts.get(List.of(0, 2)), parts.get(List.of(1, 2)), 1e-9);
        assertEquals(4, parts.get(List.of(0, 1)) / parts.get(List.of(1, 2)), 1e-9);
        assertEquals(40, parts.values().stream().mapToDouble(Double::doubleValue).sum(), 1e-9);
    }

    @Test
    void aBotThatWinsEverythingIsOrderedAfterTensOfGames() {
        List<StopRule.Order> orders = new ArrayList<>();
        for (int seeds : new int[] {5, 10, 30}) {
            orders.add(RULE.order(ratings(2, met(0, 1, 0, 0, seeds)), 0, 1));
        }
        // Each side may be wrong with 2.5%: 1/2^5 is more, 1/2^10 is less.
        assertEquals(List.of(StopRule.Order.OPEN, StopRule.Order.ORDERED, StopRule.Order.ORDERED), orders);
        // One seed that was shared changes that little.
        assertEquals(StopRule.Order.ORDERED, RULE.order(ratings(2, met(0, 1, 0, 1, 29)), 0, 1));
        // The same among others, whichever of the two is named first; and those that do not differ are in doubt.
        Ratings five = ratings(4, met(0, 1, 0, 0, 30), met(0, 2, 0, 0, 30), met(0, 3, 0, 0, 30),
            met(1, 2, 7, 15, 8), met(1, 3, 8, 15, 7), met(2, 3, 7, 16, 7));
        assertEquals(StopRule.Order.ORDERED, RULE.order(five, 0, 1));
        assertEquals(StopRule.Order.ORDERED, RULE.order(five, 3, 0));
        assertEquals(StopRule.Order.OPEN, RULE.order(five, 1, 2));
    }
}
