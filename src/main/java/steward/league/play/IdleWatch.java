package steward.league.play;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import steward.bot.command.Platform;
import steward.league.play.Roster.Member;

/**
 * Watch for games that nobody plays, which reports that they wait for a machine or why they can never be played. Not
 * thread-safe.
 */
final class IdleWatch {

    /** How long nothing may happen before anything is said, in nanoseconds. */
    static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final boolean playsHere;
    private final Consumer<String> teller;
    private boolean still;
    private long since;
    private boolean said;

    /** @param playsHere true if this machine plays games, too */
    IdleWatch(boolean playsHere, Consumer<String> teller) {
        this.playsHere = playsHere;
        this.teller = teller;
    }

    /** Notes that games are played, or may be. */
    void moves() {
        still = false;
        said = false;
    }

    /**
     * Looks at games that have been decided on while none is under way.
     *
     * @param waiting   the bots of each game, none if no game has been decided on
     * @param remote    other machines, or {@code null}
     * @param now       as of {@link System#nanoTime}
     * @return why none of them can be played by the machines that are there; empty if one may be
     */
    Optional<String> look(List<List<Member>> waiting, RemoteMachines remote, long now) {
        boolean away = remote == null || remote.isAway();
        boolean here = playsHere && (waiting.isEmpty() || waiting.stream().anyMatch(IdleWatch::isForHere));
        List<String> obstacles = away ? List.of() : waiting.stream().map(remote::obstacle).toList();
        if (here || obstacles.stream().anyMatch(Objects::isNull)) {
            moves();
            return Optional.empty();
        }
        since = still ? since : now;
        still = true;
        if (now - since < PATIENCE_NANOS) {
            return Optional.empty();
        }
        if (remote == null || !obstacles.isEmpty()) {
            return Optional.of("no machine can play " + waiting.get(0).stream().map(bot -> bot.bot().name()).distinct()
                .collect(Collectors.joining(" against ")) + ": " + (playsHere ? notHere() : "")
                + (playsHere && !obstacles.isEmpty() ? "; " : "") + (obstacles.isEmpty() ? "" : obstacles.get(0))
                + "; expected a machine that can, or another command, or 'steward league retire'");
        }
        if (away && !said) {
            said = true;
            teller.accept("games wait for a worker: none is connected, and "
                + (playsHere ? notHere() : "this league plays none itself"));
        }
        return Optional.empty();
    }

    static boolean isForHere(List<Member> bots) {
        return bots.stream().allMatch(Member::playsHere);
    }

    private static String notHere() {
        return "this machine is " + Platform.here();
    }
}
