package steward.league.play;

import java.util.HashSet;
import java.util.Set;
import java.util.function.Consumer;
import steward.league.PausedBots;
import steward.league.play.Roster.Member;
import steward.league.store.GameQueries;

/** Pauses of a run's bots that failed in many games in a row, counting games of earlier runs too. Not thread-safe. */
final class Pauses {

    private final int most;
    private final int next;
    private final OpenSeason season;
    private final GameQueries queries;
    private final Consumer<String> teller;
    private final PausedBots bots;
    /** Versions whose earlier failures are known. */
    private final Set<Integer> known = new HashSet<>();
    private Roster roster;

    /**
     * Pauses of a run that begins.
     *
     * @param most games in a row; 0 for never
     * @param next the decision that is made next
     */
    Pauses(int most, int lag, int next, OpenSeason season, Consumer<String> teller) {
        this.most = most;
        this.next = next;
        this.season = season;
        this.teller = teller;
        queries = season.queries();
        bots = new PausedBots(most, lag);
    }

    PausedBots bots() {
        return bots;
    }

    /** Takes bots that play from now on. */
    void use(Roster bots) {
        roster = bots;
        for (Member member : bots.members()) {
            int version = member.version().id();
            this.bots.resume(version, member.bot().resumed());
            if (known.add(version)) {
                if (member.version().paused()) {
                    season.store().pause(version, false);          // until it is paused again
                }
                if (most > 0) {
                    queries.failures(version, (decision, failed) -> this.bots.earlier(next, decision, version, failed));
                }
            }
            if (member.unsteady() != null) {
                this.bots.pause(version);
            }
        }
    }

    /** Notes and tells that a version is paused. */
    void tell(int version) {
        Member member = roster.byVersion().get(version);
        season.store().pause(version, true);
        String league = season.folder().path().toString();
        String why = member.unsteady() != null ? member.unsteady() + " has made a third version of it within "
            + RosterReader.STEADY + " games, and at --sandbox off a bot can write to its own files; "
            : "it failed in " + most + " games in a row; 'steward league games " + league + " --failed' says how, ";
        teller.accept(member.version().display() + " is paused: " + why + "'steward league resume " + league + " "
            + member.bot().name() + "' lets it play again");
    }
}
