package steward.cli.resident;

import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.ToIntBiFunction;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.league.run.LeagueRunCommand;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;
import steward.files.InputException;

/** {@code steward resident}: serves the clients of one socket, several at a time, until none has come for a while. */
@Command(name = "resident", description = "Plays the matches of 'steward-referee' and 'steward-play', which work "
    + "like 'steward referee' and 'steward play' but start no Java for each match.",
    footer = {
        "", "'steward-referee' and 'steward-play' are small programs beside 'steward', made",
        "on Linux if there is a C compiler. They start a resident themselves if none",
        "runs. A resident serves one user, folder, environment, control group, set of",
        "limits and so on. A call that differs in any of these gets another resident, or",
        "starts Java.",
        "", "Example, for another --idle, or to have it before the first match:",
        "  steward resident --idle 8h &",
        "", "Exit status: 0 it was idle for that long; 2 wrong call, or a resident already",
        "runs."})
public final class ResidentCommand extends ProgramCommand {

    private final ToIntBiFunction<Streams, String[]> program;
    private final AtomicInteger sessions = new AtomicInteger();
    private volatile long lastNanos;

    @Option(names = "--idle", paramLabel = "TIME", defaultValue = "10m",
        description = "Ends when there was no match for so long, such as 90s, 30m or 8h (default: 10m).")
    private String idle;

    @Option(names = "--socket", paramLabel = "FILE", description = "The socket to serve, in a folder that only "
        + "its user may open. Without it the client chooses one, named by everything on which matches could "
        + "depend.")
    private String socket;

    /** @param program runs a command, its name first, and returns its exit status */
    public ResidentCommand(ToIntBiFunction<Streams, String[]> program) {
        this.program = program;
    }

    @Override
    public Integer call() {
        long idleNanos = LeagueRunCommand.nanos("--idle", idle);
        check.that(socket != null, "found no --socket and no client that names one, expected an installation made with "
            + "a C compiler, on Linux");
        try {
            serve(Path.of(socket), idleNanos);
        } catch (IOException | UnsupportedOperationException problem) {
            throw new InputException("--socket: " + socket + " cannot be served: " + problem.getMessage());
        }
        return ExitStatus.DONE;
    }

    private void serve(Path path, long idleNanos) throws IOException {
        Path made = path.resolveSibling(path.getFileName() + ".new");      // it has its name when it can be connected
        Files.deleteIfExists(made);
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
                Selector selector = Selector.open()) {
            server.bind(UnixDomainSocketAddress.of(made));
            // Each level is tried once in a JVM. Tried now, it is not broken off with the first match.
            SandboxSupport.problem(SandboxLevel.LIGHT);
            SandboxSupport.problem(SandboxLevel.STRICT);
            Files.move(made, path, StandardCopyOption.ATOMIC_MOVE);
            server.configureBlocking(false);
            server.register(selector, SelectionKey.OP_ACCEPT);
            lastNanos = System.nanoTime();
            streams.out().println("steward: resident serves " + path + " and ends when it was idle for " + idle);
            streams.out().flush();
            for (long left = idleNanos; left > 0; left = leftNanos(idleNanos)) {
                selector.select(Math.max(1, TimeUnit.NANOSECONDS.toMillis(left)));
                selector.selectedKeys().clear();
                for (SocketChannel client = server.accept(); client != null; client = server.accept()) {
                    begin(client, path);
                }
            }
            Files.deleteIfExists(path);
        }
    }

    private long leftNanos(long idleNanos) {
        return sessions.get() > 0 ? idleNanos : idleNanos + lastNanos - System.nanoTime();
    }

    private void begin(SocketChannel client, Path path) {
        sessions.incrementAndGet();
        new Thread(() -> {
            try {
                new Session(client, program).serve(Files.getOwner(path));
            } catch (IOException gone) {
                // The client has gone, and its match has ended.
                return;
            } finally {
                lastNanos = System.nanoTime();
                sessions.decrementAndGet();
            }
        }, "steward-session").start();
    }
}
