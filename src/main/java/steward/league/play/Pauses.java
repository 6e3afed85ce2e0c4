package steward.league.play;

import java.util.HashSet;
import java.util.Set;
import java.util.function.Consumer;
import steward.league.LeagueFolder;
import steward.league.PausedBots;
import steward.league.Schedule;
import steward.league.play.Roster.Member;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;

/** Pauses the bots of a run that failed in many games in a row, those of earlier runs included. Not thread-safe. */
final class Pauses {

    private final int most;
    private final LeagueFolder folder;
    private final GameStore store;
    private final GameQueries queries;
    private final Consumer<String> teller;
    private final PausedBots bots;
    /** Versions whose earlier failures are known. */
    private final Set<Integer> learnt = new HashSet<>();
    private Roster roster;

    /** @param most games in a row; 0 for never */
    Pauses(int most, int lag, int settled, LeagueFolder folder, GameStore store, GameQueries queries,
           Consumer<String> teller) {
        this.most = most;
        this.folder = folder;
        this.store = store;
        this.queries = queries;
        this.teller = teller;
        bots = new PausedBots(most, lag, settled);
    }

    /** Takes bots that play from now on. */
    void use(Roster next, Schedule schedule) {
        roster = next;
        for (Member member : next.members()) {
            int version = member.version().id();
            bots.resume(version, member.bot().resumed());
            boolean isNew = learnt.add(version);
            if (isNew && member.version().paused()) {
                store.pause(version, false);           // until it is paused again
            }
            if (member.unsteady() != null) {
                bots.pause(version);
            }
            if (most > 0 && isNew) {
                queries.failures(version, (decision, failed) -> bots.earlier(decision, version, failed));
            }
        }
        schedule.pausing(bots, this::tell);
    }

    private void tell(int version) {
        Member member = roster.byVersion().get(version);
        store.pause(version, true);
        String why = member.unsteady() != null ? member.unsteady() + " has made a third version of it within "
            + RosterReader.STEADY + " games, and at --sandbox off a bot can write to its own files; "
            : "it failed in " + most + " games in a row; 'steward league games " + folder.path()
                + " --failed' says how, ";
        teller.accept(member.version().display() + " is paused: " + why + "'steward league resume " + folder.path()
            + " " + member.bot().name() + "' lets it play again");
    }
}
