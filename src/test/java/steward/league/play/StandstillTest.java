package steward.league.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import steward.bot.command.Platform;
import steward.contest.Contest;
import steward.league.LeagueBot;
import steward.league.StoredGame;
import steward.league.play.Roster.Member;
import steward.league.store.GameStore;
import steward.match.Protocol;

/** Games that nobody plays, with a clock of the test. */
class StandstillTest {

    private static final List<List<Member>> WAITING = List.of(List.of(member("a"), member("b@linux-s390x")));

    private final List<String> told = new ArrayList<>();
    private boolean away = true;
    private String obstacle;

    private static Member member(String name) {
        LeagueBot bot = new LeagueBot(name, "sh bot.sh", List.of(), false, false);
        return new Member(bot, new GameStore.Version(1, name, 1, bot.command(), false, name, 0, false, null),
            Contest.entrant(bot.typed(), Protocol.JSON), "", null);
    }

    private Optional<String> look(IdleWatch standstill, int millis) {
        return standstill.look(WAITING, new Others(), TimeUnit.MILLISECONDS.toNanos(millis));
    }

    @Test
    void gamesThatWaitForAWorkerAreSaidToOnce() {
        IdleWatch standstill = new IdleWatch(false, told::add);
        for (int millis : List.of(1000, 3000, 5999)) {
            assertEquals(Optional.empty(), look(standstill, millis));
            assertEquals(List.of(), told);
        }
        List<String> expected = List.of("games wait for a worker: none is connected, and this league plays none "
            + "itself");
        for (int millis : List.of(6000, 9000, 90_000)) {
            assertEquals(Optional.empty(), look(standstill, millis));
            assertEquals(expected, told);
        }
        away = false;
        assertEquals(Optional.empty(), look(standstill, 91_000), "a worker that may play them is there");
        away = true;
        look(standstill, 92_000);
        assertEquals(expected, told);
        look(standstill, 97_000);
        assertEquals(List.of(expected.get(0), expected.get(0)), told);
    }

    @Test
    void whatNoWorkerCanPlayEndsTheRun() {
        IdleWatch standstill = new IdleWatch(true, told::add);
        away = false;
        obstacle = "worker w: no such library";
        assertEquals(Optional.empty(), look(standstill, 0));
        standstill.moves();
        assertEquals(Optional.empty(), look(standstill, 4000));
        assertEquals(Optional.empty(), look(standstill, 8999));
        String why = look(standstill, 9000).orElseThrow();
        assertTrue(why.startsWith("no machine can play a against b@linux-s390x: this machine is " + Platform.here()
            + "; worker w: no such library; expected "), why);
        assertEquals(List.of(), told);
    }

    @Test
    void whatThisMachineCanPlayWaitsForNobody() {
        IdleWatch standstill = new IdleWatch(true, told::add);
        List<List<Member>> here = List.of(WAITING.get(0), List.of(member("a"), member("c")));
        for (int seconds : List.of(0, 10, 100)) {
            assertEquals(Optional.empty(), standstill.look(here, new Others(), TimeUnit.SECONDS.toNanos(seconds)));
        }
        assertEquals(List.of(), told);
    }

    /** Other machines, which are away, or have an obstacle or none. */
    private final class Others implements RemoteMachines {

        @Override
        public boolean isAway() {
            return away;
        }

        @Override
        public String obstacle(List<Member> members) {
            return obstacle;
        }

        @Override
        public int takePlace(long waitMs) {
            throw new AssertionError("it only looks");
        }

        @Override
        public void leavePlace() {
            throw new AssertionError("it only looks");
        }

        @Override
        public List<List<StoredGame>> play(List<Game> games) {
            throw new AssertionError("it only looks");
        }

        @Override
        public void hurry() {
            throw new AssertionError("it only looks");
        }

        @Override
        public boolean canPlay(List<Member> members) {
            throw new AssertionError("it only looks");
        }

        @Override
        public boolean isTrusted(String machine) {
            throw new AssertionError("it only looks");
        }
    }
}
