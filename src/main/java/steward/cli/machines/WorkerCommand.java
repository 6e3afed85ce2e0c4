package steward.cli.machines;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.bot.command.Platform;
import steward.bot.isolation.Isolation;
import steward.cli.league.run.LeagueRunCommand;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SandboxOptions;
import steward.cli.options.ThreadsOption;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.ProgramVersion;
import steward.cli.streams.Interruption;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.files.UserFolders;
import steward.machines.token.Invitation;
import steward.machines.token.PrivateFile;
import steward.machines.token.WorkerToken;
import steward.machines.worker.Worker;
import steward.text.TextFormat;

/** {@code steward worker}: plays games of a league that runs on another machine. */
@Command(name = "worker", description = "Plays games of a league that runs elsewhere with 'league run --serve'.",
    footer = {
        "", "'steward league worker add' or 'invite' makes the token; without --token-file",
        "it is the text in the variable STEWARD_TOKEN. Bots are isolated at level strict",
        "unless told otherwise, because they are other people's programs. After Ctrl-C,",
        "games under way are finished, and no others begun.",
        "", "Example:",
        "  steward worker --join attic.example:7161 --token-file mine.token",
        "", "Exit status: 0 told to end; 1 broken: a message of the league cannot be used; 2",
        "the call or a file is unusable; 3 refused: wrong token, program version or",
        "league; 130 interrupted, 143 terminated."})
public final class WorkerCommand extends ProgramCommand {

    private static final String VARIABLE = "STEWARD_TOKEN";
    /** Digits of the broker's key in the name of a file, so that a machine may play for several leagues. */
    private static final int BROKER_DIGITS = 8;

    /** The streams with a log; set when the command is called. */
    private Streams log;

    @Option(names = "--join", required = true, paramLabel = "HOST:PORT", description = "The address on which the "
        + "league listens.")
    private String address;

    @Option(names = "--token-file", paramLabel = "FILE", description = "The worker's token, or an invitation (default: "
        + "the text in the variable " + VARIABLE + ").")
    private String tokenFile;

    @Option(names = "--key-file", paramLabel = "FILE", description = "With an invitation as the token: the file "
        + "of this machine's own key (default: HOST.token in steward/keys in the user's state folder).")
    private String keyFile;

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Option(names = "--games", paramLabel = "N", description = "Ends after N games.")
    private Long games;

    @Option(names = "--for", paramLabel = "TIME", description = "Ends after so long, such as 90s, 30m, 8h or 2d.")
    private String time;

    @Option(names = "--bundles", paramLabel = "DIR", description = "The folder for unpacked bots (default: "
        + "steward/bundles in the user's cache folder).")
    private String bundles;

    @Option(names = "--guests", description = "Also plays for leagues whose scene has its own referee program, "
        + "which is fetched and run here, isolated like a bot.")
    private boolean guests;

    @Option(names = "--platform", paramLabel = "PLATFORM", description = "Plays bots and commands for this "
        + "platform, such as linux-aarch64 (default: this machine's).")
    private String platform;

    @Option(names = "--idle", paramLabel = "TIME", description = "Ends after this time without a game, such as "
        + "10m.")
    private String idle;

    @Option(names = "--stop-file", paramLabel = "FILE", description = "Ends, as after Ctrl-C, when this file "
        + "exists.")
    private String stopFile;

    @Option(names = "--json", description = "Prints each event as a line of JSON with its time.")
    private boolean json;

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    @Override
    public Integer call() throws InterruptedException {
        threads.check();
        log = streams.logging(json);
        check.range("--games", games, 1, Integer.MAX_VALUE);
        InetSocketAddress found = ServeOptions.address(check, "--join", address);
        long nanos = LeagueRunCommand.nanos("--for", time);
        long idleNanos = LeagueRunCommand.nanos("--idle", idle);
        check.that(platform == null || Platform.isWritten(platform), "--platform: found '" + platform + "', expected "
            + Platform.FORM);
        check.that(!sandbox.isHold(), "--hold: expected none: the league says which bots are held");
        Supplier<Isolation> isolation = sandbox.isolation(streams, "strict");
        WorkerToken token = token();
        Worker worker = new Worker(new Worker.Options(found.getHostString(), found.getPort(), token,
            threads.count(streams), games == null ? Long.MAX_VALUE : games, nanos, isolation, folder(),
            platform == null ? Platform.here() : platform, ProgramVersion.text(),
            LeagueRunCommand.machine(isolation.get().level().word())), Games.types(guests),
            what -> log.err().println("steward: " + TextFormat.plain(what)));
        watch(worker, idleNanos, stopFile == null ? null : OutputFiles.path(stopFile));
        return play(worker);
    }

    /** Ends a worker that has been idle for too long, or is told to by a file. */
    private void watch(Worker worker, long idleNanos, Path file) {
        if (idle == null && file == null) {
            return;
        }
        Thread watch = new Thread(() -> {
            while (worker.idleNanos() < idleNanos && (file == null || Files.notExists(file))) {
                try {
                    Thread.sleep(250);
                } catch (InterruptedException end) {
                    return;
                }
            }
            worker.drain();
        }, "end of a worker");
        watch.setDaemon(true);
        watch.start();
    }

    @SuppressWarnings("try")                           // only closed, never used
    private int play(Worker worker) throws InterruptedException {
        CountDownLatch over = new CountDownLatch(1);
        try (Interruption interruption = new Interruption(log, () -> {
            if (over.getCount() == 0) {
                return null;
            }
            worker.drain();
            log.err().println("steward: the games that are under way are finished, no others begun");
            try {
                over.await();
            } catch (InterruptedException end) {
                Thread.currentThread().interrupt();
            }
            return TextFormat.count(worker.played(), "game") + " played";
        })) {
            try {
                worker.play();
            } finally {
                over.countDown();                      // before the interruption is waited for
            }
        } catch (Worker.RefusedException | InputException end) {
            log.err().println("steward: " + TextFormat.plain(end.getMessage()));
            return end instanceof InputException ? ExitStatus.FAILED : ExitStatus.REFUSED;
        }
        streams.out().println(TextFormat.count(worker.played(), "game") + " played");
        return ExitStatus.DONE;
    }

    private WorkerToken token() {
        Path file = tokenFile == null ? null : OutputFiles.path(tokenFile);
        String text = System.getenv(VARIABLE);
        check.that(file != null || text != null, "found no --token-file, and no variable " + VARIABLE
            + ", expected one of them");
        Invitation.Letter letter = file == null ? Invitation.letter(text, VARIABLE) : Invitation.letter(file);
        check.that(letter != null || keyFile == null, "--key-file is for an invitation, expected a token of this "
            + "worker without it");
        WorkerToken token = letter != null ? invited(letter) : file == null ? WorkerToken.parse(text, VARIABLE)
            : WorkerToken.read(file);
        String warning = file == null ? null : PrivateFile.warning(file);
        if (warning != null) {
            log.warn(warning);
        }
        return token;
    }

    private WorkerToken invited(Invitation.Letter letter) {
        String host = host();
        return WorkerToken.invited(letter, keyFile != null ? OutputFiles.path(keyFile)
            : UserFolders.folder("XDG_STATE_HOME", ".local/state").resolve("keys")
                .resolve(letter.broker().substring(0, BROKER_DIGITS) + "-" + host + ".token"), host);
    }

    private static String host() {
        try {
            return InetAddress.getLocalHost().getHostName().replace('/', '-');
        } catch (UnknownHostException unnamed) {
            return "worker";
        }
    }

    private Path folder() {
        return bundles != null ? OutputFiles.path(bundles) : UserFolders.cache().resolve("bundles");
    }
}
