package steward.cli.machines;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import steward.cli.league.Serving;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.play.LeagueRun;
import steward.league.play.Roster.Member;
import steward.machines.serve.RemoteGames;
import steward.machines.serve.WorkerSeen;

/** Workers of a run, and what is shown of them. */
final class ServedGames implements Serving.Service {

    private static final double MS = 1000;

    private final RemoteGames games;

    ServedGames(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings,
                InetSocketAddress address, double share, long leaseNanos, Consumer<String> teller) {
        games = new RemoteGames(folder, season, contest, settings, Games.types(), new RemoteGames.Service(address,
            share, leaseNanos, ProgramVersion.text()), teller);
        teller.accept("workers can join at " + address.getHostString() + ":" + address.getPort());
    }

    @Override
    public void follow(LeagueRun run, Runnable changed) {
        games.onCaught((machine, why) -> {
            int count = run.setAside(machine, why);
            changed.run();
            return count;
        });
    }

    @Override
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        for (WorkerSeen worker : games.seen()) {
            String state = worker.caught() ? "caught" : worker.slots() == 0 ? "away" : worker.slots() + " at a time";
            lines.add(String.format(Locale.ROOT, "worker %s: %s, %d games, %.2f games/s, %d faults, %d hiccups, "
                + "steward %s, last word %.0f s ago", worker.name(), state, worker.games(), worker.rate(),
                worker.faults(), worker.repeated(), worker.version(), worker.silentMs() / MS));
        }
        return lines;
    }

    @Override
    public int most() {
        return games.most();
    }

    @Override
    public boolean takePlace(long waitMs) throws InterruptedException {
        return games.takePlace(waitMs);
    }

    @Override
    public void leavePlace() {
        games.leavePlace();
    }

    @Override
    public List<StoredGame> play(Schedule.Task task, LeagueSettings settings, List<Member> members)
            throws InterruptedException {
        return games.play(task, settings, members);
    }

    @Override
    public boolean isTrusted(String machine) {
        return games.isTrusted(machine);
    }

    @Override
    public void close() {
        games.close();
    }
}
