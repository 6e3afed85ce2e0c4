package steward.league.play;

import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import steward.bot.command.Platform;
import steward.league.play.Roster.Member;

/**
 * Watch over games that nobody plays: it says that they wait for a machine, and why they will never be played. Not
 * thread-safe.
 */
final class Standstill {

    /** How long nothing may happen before anything is said, in nanoseconds. */
    static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(5);

    private final boolean playsHere;
    private final Consumer<String> teller;
    private boolean still;
    private long since;
    private boolean said;

    /** @param playsHere true if this machine plays games, too */
    Standstill(boolean playsHere, Consumer<String> teller) {
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
     * @param elsewhere other machines, or {@code null}
     * @param now       as of {@link System#nanoTime}
     * @return why none of them can be played by the machines that are there, or {@code null}
     */
    String look(List<List<Member>> waiting, Elsewhere elsewhere, long now) {
        boolean away = elsewhere == null || elsewhere.isAway();
        boolean here = playsHere && (waiting.isEmpty() || waiting.stream().anyMatch(Standstill::isForHere));
        if (here || !away && waiting.stream().anyMatch(bots -> elsewhere.obstacle(bots) == null)) {
            moves();
            return null;
        }
        since = still ? since : now;
        still = true;
        if (now - since < PATIENCE_NANOS) {
            return null;
        }
        if (elsewhere == null || !away && !waiting.isEmpty()) {
            List<Member> bots = waiting.get(0);
            return "no machine can play " + String.join(" against ", bots.stream().map(bot -> bot.bot().name())
                .distinct().toList()) + ": " + (elsewhere == null ? notHere() : notHereNor(elsewhere.obstacle(bots)))
                + "; expected a machine that can, or another command, or 'steward league retire'";
        }
        if (away && !said) {
            said = true;
            teller.accept("games wait for a worker: none is connected, and "
                + (playsHere ? notHere() : "this league plays none itself"));
        }
        return null;
    }

    static boolean isForHere(List<Member> bots) {
        return bots.stream().allMatch(Member::playsHere);
    }

    private String notHereNor(String obstacle) {
        return (playsHere ? notHere() + "; " : "") + obstacle;
    }

    private static String notHere() {
        return "this machine is " + Platform.here();
    }
}
