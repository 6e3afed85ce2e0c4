package steward.cli.machines;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.cli.league.run.Serving;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.page.WorkerRow;
import steward.league.play.LeagueRun;
import steward.league.play.RemoteMachines;
import steward.machines.check.WorkerBook;
import steward.machines.serve.RemoteGames;
import steward.machines.serve.WorkerSeen;

/** Service that lets workers play games of a run, and reports on the workers. */
final class ServedGames implements Serving.Service {

    private final RemoteGames games;
    private final Consumer<String> teller;
    private volatile WorkerBook book = new WorkerBook(Integer::toString);

    ServedGames(LeagueFolder folder, Season season, Contest contest, LeagueSettings settings,
                RemoteGames.Service service, Consumer<String> teller) {
        games = new RemoteGames(folder, season, contest, settings, Games.types(), service, teller);
        this.teller = teller;
        teller.accept("workers can join at " + service.address().getHostString() + ":" + service.address().getPort());
    }

    @Override
    public RemoteMachines games() {
        return games;
    }

    @Override
    public void follow(LeagueRun run, Supplier<WorkerBook> read, Runnable changed) throws InterruptedException {
        book = read.get();
        games.onCaught((fate, machine, why) -> {
            int count = switch (fate) {
                case ASIDE -> run.setAside(machine, why);
                case SUSPENDED -> run.suspend(machine, why);
                case RESTORED -> run.restore(machine);
            };
            book = read.get();
            changed.run();
            return count;
        });
    }

    @Override
    public void stored(StoredGame game) {
        games.stored(game);
        book.add(game).forEach(doubt ->
            teller.accept("worker " + WorkerBook.worker(game.machine()) + " is doubtful: " + doubt));
    }

    @Override
    public int waiting() {
        return games.waiting();
    }

    @Override
    public List<WorkerRow> workers() {
        Map<String, WorkerBook.Line> lines = book.lines().stream()
            .collect(Collectors.toMap(WorkerBook.Line::name, line -> line));
        return games.seen().stream().map(worker -> row(worker, lines.getOrDefault(worker.name(),
            new WorkerBook.Line(worker.name(), 0, 0, false, 0, 0, List.of())))).toList();
    }

    private static WorkerRow row(WorkerSeen worker, WorkerBook.Line line) {
        String state = worker.caught() ? "caught" : worker.suspended() ? WorkerRow.SUSPENDED
            : worker.slots() == 0 ? "away" : worker.slots() + " at a time";
        return new WorkerRow(worker.name(), state, line.games(), line.aside(), worker.rate(), line.faults(),
            line.repeated(), worker.version(), worker.silentMs(),
            Stream.concat(line.doubts().stream(), worker.doubts().stream()).toList());
    }

    @Override
    public void close() {
        games.close();
    }
}
