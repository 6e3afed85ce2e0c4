package steward.cli.sequential;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import steward.contest.Contest;
import steward.contest.PairedPlay;
import steward.contest.repeat.Repeats;
import steward.text.TextFormat;

/**
 * Choice of seeds that tell two bots apart and are fair to all seats. Both bots have played each seed from all seats.
 * With d the difference of their mean points, -1..1, and s the greatest distance of a seat's mean points from 1/2, a
 * seed is worth |d| - 2 s. For two players that is 1 if one bot won from both sides, and 0 or less if the side decided.
 * Seeds worth more than 0 are chosen, the best first, equal ones in their order. A seed with a game in which one of the
 * two failed is skipped: a failure says something about the program, not about the seed.
 */
final class SeedChoice {

    private final Contest contest;
    private final int wanted;
    private final List<Candidate> found = new ArrayList<>();
    private final Repeats seen = new Repeats();
    private int played;
    private int best;
    private int bySeat;
    private int even;
    private int repeats;
    private int repeatsInARow;
    private int without;
    private int failed;

    /**
     * A seed that may be chosen.
     *
     * @param place      among all that were played
     * @param difference of the mean points of the two bots
     */
    record Candidate(long seed, int place, double difference, double worth) { }

    /** None yet. @param wanted how many are to be chosen */
    SeedChoice(Contest contest, int wanted) {
        this.contest = contest;
        this.wanted = wanted;
    }

    /** Takes the games of a seed; returns whether more can improve the choice. */
    boolean take(PairedPlay.Seed seed) {
        played++;
        boolean isRepeat = seed.isWhole() && seed.isRepeat(seen);
        repeatsInARow = isRepeat ? repeatsInARow + 1 : 0;
        if (!seed.isWhole()) {
            without++;
        } else if (seed.isAnyFailed()) {
            failed++;
        } else if (isRepeat) {
            repeats++;
        } else {
            double difference = seed.difference(contest, 0, 1);
            double advantage = seed.seatAdvantage();
            double worth = Math.abs(difference) - 2 * advantage;
            if (worth > 0) {
                found.add(new Candidate(seed.seed(), played, difference, worth));
                best += worth == 1 ? 1 : 0;
            } else {
                bySeat += advantage > 0 ? 1 : 0;
                even += advantage > 0 ? 0 : 1;
            }
        }
        return best < wanted && repeatsInARow < Repeats.ENOUGH;
    }

    /** Number of seeds of the greatest worth so far. */
    int best() {
        return best;
    }

    /** Returns the chosen ones, in the order in which they were played. */
    List<Candidate> chosen() {
        return found.stream().sorted(Comparator.comparing(Candidate::worth).reversed()).limit(wanted)
            .sorted(Comparator.comparing(Candidate::place)).toList();
    }

    /** Returns a line of a file for each chosen one: the seed, and as a comment which bot it was for. */
    List<String> lines() {
        return chosen().stream().map(each -> each.seed() + "  # "
            + TextFormat.plain(contest.entrants().get(each.difference() > 0 ? 0 : 1).name()) + " ahead by "
            + TextFormat.number(Math.abs(each.difference()), 3)).toList();
    }

    /** Returns sentences on how they were chosen. */
    List<String> account() {
        List<Candidate> chosen = chosen();
        long first = chosen.stream().filter(each -> each.difference() > 0).count();
        String seats = contest.isAlone() ? "each alone" : "from all seats";
        return List.of(
            "The two bots played " + TextFormat.count(played, "seed") + " " + seats + "; these games count nowhere.",
            "A seed is worth |d| - 2 s: d is the difference of the bots' mean points, s the greatest",
            "distance of a seat's mean points from 1/2. Chosen are the worthiest above 0.",
            "Chosen: " + chosen.size() + ", " + first + " for " + name(0) + ", " + (chosen.size() - first) + " for "
                + name(1) + ". Passed over: " + (found.size() - chosen.size()) + " others above 0, " + bySeat
                + " that a seat decided,",
            even + " that told nothing, " + repeats + " that only repeat games, " + failed + " in which a bot failed, "
                + without + " without a result.");
    }

    private String name(int entrant) {
        return TextFormat.plain(contest.entrants().get(entrant).name());
    }
}
