package steward.cli.machines;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.options.CallCheck;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Streams;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.machines.token.BrokerKey;
import steward.machines.token.WorkerList;

/** {@code steward league worker}: who may play for a league. */
@Command(name = "worker", description = "Says which workers may play for a league: add, revoke, pardon, list; renew "
    + "the broker's certificate.",
    footer = {"",
        "add makes a token, a file that belongs to one worker; keep it as you would a",
        "password. revoke ends what it allows, also while the league is played; with",
        "--set-aside the worker's games do not count and are played again. pardon lets a",
        "revoked worker play again with the token that it has; add gives it a new one.",
        "renew makes a new certificate for the broker's key, which workers go on trusting.",
        "", "Examples:",
        "  steward league worker add night attic",
        "  steward league worker revoke night attic"})
final class LeagueWorkerCommand implements Callable<Integer> {

    private final Streams streams;
    private final CallCheck check = CallCheck.withHelp();

    @Parameters(index = "0", paramLabel = "ACTION", description = "add, revoke, pardon, list or renew.")
    private String action;

    @Parameters(index = "1", paramLabel = "DIR", description = "The folder of the league.")
    private String folder;

    @Parameters(index = "2", arity = "0..1", paramLabel = "NAME", description = "The worker, for add, revoke "
        + "and pardon.")
    private String name;

    @Option(names = "--out", paramLabel = "FILE", description = "With add: where the token goes (default: NAME.token).")
    private String out;

    @Option(names = "--set-aside", description = "With revoke: the worker's games do not count, and 'league run "
        + "--serve' plays them again.")
    private boolean aside;

    LeagueWorkerCommand(Streams streams) {
        this.streams = streams;
    }

    @Override
    public Integer call() {
        boolean named = List.of("add", "revoke", "pardon").contains(action);
        check.that(named || action.equals("list") || action.equals("renew"), "found '" + action
            + "', expected add, revoke, pardon, list or renew");
        check.that(named == (name != null), named ? "found no NAME, expected that of a worker"
            : "found the name '" + name + "', expected none with " + action);
        check.that(out == null || action.equals("add"), "--out is for add, expected none with " + action);
        check.that(!aside || action.equals("revoke"), "--set-aside is for revoke, expected none with " + action);
        Path path = OutputFiles.path(folder);
        LeagueFolder league = action.equals("list") ? LeagueFolder.open(path)
            : LeagueFolder.openToWrite(path, streams::warn);
        switch (action) {
            case "add" -> {
                Path token = OutputFiles.path(out == null ? name + ".token" : out);
                WorkerList.add(league, name, token);
                streams.out().println(token + ": the token of " + name + "; on its machine:");
                streams.out().println("  steward worker --join HOST:PORT --token-file " + token);
            }
            case "revoke" -> {
                WorkerList.revoke(league, name, "by hand", aside);
                streams.out().println(name + " is revoked");
            }
            case "pardon" -> {
                WorkerList.pardon(league, name);
                streams.out().println(name + " may play again");
            }
            case "renew" -> {
                BrokerKey key = new BrokerKey(league);
                key.make();
                key.renew();
                streams.out().println("A new certificate for the key " + key.fingerprint());
            }
            default -> WorkerList.read(league).workers().forEach(worker -> streams.out().println(worker.name()
                + (worker.revoked() == null ? "" : " (revoked: " + worker.revoked() + ")")));
        }
        return ExitStatus.DONE;
    }
}
