package steward.cli.machines;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.league.view.LeagueOpening;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Json;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.league.store.AsideGames;
import steward.league.store.GameStore;
import steward.machines.check.WorkerBook;
import steward.machines.token.BrokerKey;
import steward.machines.token.Invitation;
import steward.machines.token.WorkerList;
import steward.report.Fields;
import steward.text.TextFormat;

/** {@code steward league worker}: manages which machines may play for a league. */
@Command(name = "worker", description = "Manages which workers may play for a league: add, invite, revoke, "
    + "pardon, list. Renews the broker's certificate.",
    footer = {
        "", "add      makes a token, a file that belongs to one worker; keep it secret like",
        "         a password. For a revoked worker it makes a new one.",
        "invite   makes one file for many machines. Each makes a key of its own with it,",
        "         and is then a worker with the name of its host.",
        "revoke   ends a token, even while the league is played. With --set-aside the",
        "         worker's games do not count and are played again. It also ends an",
        "         invitation; workers that joined with it stay until they are revoked.",
        "pardon   lets a revoked or suspended worker play again with its token.",
        "renew    makes a new certificate for the broker's key, which workers still",
        "         trust.",
        "", "A worker is suspended if its answers differ too often from those of its bots.",
        "It then gets no games. Its games count again after pardon, and never after",
        "revoke.",
        "", "--json, with list: workers (name, invitation or null, revoked: why, or null,",
        "suspended, doubts: by games and answers), invitations (name, until, used,",
        "count, revoked).",
        "", "Examples:",
        "  steward league worker add night attic",
        "  steward league worker invite night --count 40 --until 2030-12-24",
        "  steward league worker revoke night attic"})
public final class LeagueWorkerCommand extends ProgramCommand {

    private static final List<String> ACTIONS = List.of("add", "invite", "revoke", "pardon", "list", "renew");

    @Parameters(index = "0", paramLabel = "ACTION", description = "add, invite, revoke, pardon, list or "
        + "renew.")
    private String action;

    @Parameters(index = "1", paramLabel = "DIR", description = "The folder of the league.")
    private String folder;

    @Parameters(index = "2", arity = "0..1", paramLabel = "NAME", description = "The worker, for add, revoke "
        + "and pardon; the invitation, for invite (default: invitation) and revoke.")
    private String name;

    @Option(names = "--out", paramLabel = "FILE", description = "With add and invite: the file of the token or "
        + "invitation (default: NAME.token).")
    private String out;

    @Option(names = "--count", paramLabel = "N", description = "With invite: N machines may use it.")
    private Integer count;

    @Option(names = "--until", paramLabel = "DATE", description = "With invite: the last day (2030-12-24) or "
        + "moment (2030-12-24T18:00) at which a machine may use it.")
    private String until;

    @Option(names = "--set-aside", description = "With revoke: the worker's games do not count, and 'league run "
        + "--serve' plays them again.")
    private boolean aside;

    @Option(names = "--json", description = "With list: prints one JSON object instead; see below.")
    private boolean json;

    @Override
    public Integer call() {
        check.that(ACTIONS.contains(action), "found '" + action + "', expected add, invite, revoke, pardon, list or "
            + "renew");
        boolean named = List.of("add", "revoke", "pardon").contains(action);
        boolean invites = action.equals("invite");
        check.that(invites || named == (name != null), named ? "found no NAME, expected that of a worker"
            : "found the name '" + name + "', expected none with " + action);
        check.that(out == null || action.equals("add") || invites, "--out is for add and invite, expected none with "
            + action);
        check.that(!aside || action.equals("revoke"), "--set-aside is for revoke, expected none with " + action);
        check.that(!json || action.equals("list"), "--json is for list, expected none with " + action);
        check.that(invites == (count != null) && invites == (until != null), invites
            ? "found no --count or no --until, expected both with invite"
            : "--count and --until are for invite, expected none with " + action);
        check.range("--count", count, 1, WorkerList.MOST);
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
            case "invite" -> {
                String invitation = name == null ? "invitation" : name;
                Path file = OutputFiles.path(out == null ? invitation + ".token" : out);
                Instant end = Invitation.until(until, Instant.now());
                WorkerList.invite(league, invitation, count, end, file);
                streams.out().println(file + ": an invitation for " + TextFormat.count(count, "machine") + " until "
                    + end + "; on each of them:");
                streams.out().println("  steward worker --join HOST:PORT --token-file " + file);
            }
            case "revoke" -> {
                check.that(!aside || WorkerList.read(league).invitation(name).isEmpty(),
                    "--set-aside: found an invitation, expected a worker, whose games do not count then");
                WorkerList.revoke(league, name, "by hand", aside);
                streams.out().println(name + " is revoked");
            }
            case "pardon" -> pardon(league);
            case "renew" -> {
                BrokerKey key = new BrokerKey(league);
                key.make();
                key.renew();
                streams.out().println("A new certificate for the key " + key.fingerprint());
            }
            default -> list(WorkerList.read(league), league);
        }
        return ExitStatus.DONE;
    }

    private void pardon(LeagueFolder league) {
        WorkerList.pardon(league, name);
        int games = 0;
        if (Files.exists(league.database())) {
            try (GameStore store = GameStore.write(league)) {
                games = new AsideGames(store).restore(WorkerBook.machine(name));
            }
        }
        streams.out().println(name + " may play again" + (games == 0 ? "" : "; " + TextFormat.count(games, "game")
            + (games == 1 ? " counts" : " count") + " again"));
    }

    /** Returns what is doubtful by the games of each worker, and by its answers. */
    private static Map<String, List<String>> doubts(WorkerList list, LeagueFolder league) {
        Map<String, List<String>> doubts = new HashMap<>();
        list.workers().stream().filter(worker -> worker.doubt() != null).forEach(worker ->
            doubts.computeIfAbsent(worker.name(), any -> new ArrayList<>()).add(worker.doubt()));
        if (Files.exists(league.database())) {
            try (LeagueOpening.Opened opened = LeagueOpening.read(league)) {
                opened.workers().forEach(row -> doubts.computeIfAbsent(row.name(), any -> new ArrayList<>())
                    .addAll(row.doubts()));
            } catch (InputException none) {
                return doubts;                         // there are no games yet, or 'league verify' says what is wrong
            }
        }
        return doubts;
    }

    private void list(WorkerList list, LeagueFolder league) {
        Map<String, List<String>> doubts = doubts(list, league);
        if (json) {
            Json.print(streams, Fields.of("workers", Fields.each(list.workers(), worker -> Fields.of(
                "name", worker.name(), "invitation", worker.invited(), "revoked", worker.revoked(),
                "suspended", worker.doubt() != null, "doubts", doubts.getOrDefault(worker.name(), List.of()))),
                "invitations", Fields.each(list.invitations(), each -> Fields.of("name", each.name(),
                    "until", each.until(), "used", list.used(each), "count", each.count(),
                    "revoked", each.revoked()))));
            return;
        }
        list.workers().forEach(worker -> {
            streams.out().println(worker.name() + (worker.invited() == null ? "" : " (by " + worker.invited() + ")")
                + (worker.revoked() == null ? "" : " (revoked: " + worker.revoked() + ")")
                + (worker.doubt() == null ? "" : " (suspended: its games do not count until pardon or revoke)"));
            doubts.getOrDefault(worker.name(), List.of()).forEach(doubt ->
                streams.out().println(TextFormat.plain("  doubtful: " + doubt)));
        });
        list.invitations().forEach(each -> streams.out().println(each.name() + ": an invitation until " + each.until()
            + ", used by " + list.used(each) + " of " + TextFormat.count(each.count(), "machine")
            + (each.revoked() ? " (revoked)" : "")));
    }
}
