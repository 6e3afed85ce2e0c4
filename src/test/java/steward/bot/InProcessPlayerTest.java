package steward.bot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import steward.bot.process.ScriptedBots;

/** A bot inside this JVM is treated like a bot program. */
class InProcessPlayerTest {

    /** Remembers the lines it is sent and gives the answers it was given. */
    private static final class Notebook implements Bot {
        private final List<String> heard = new ArrayList<>();
        private final String says;

        Notebook(String says) {
            this.says = says;
        }

        @Override
        public void setup(String line) {
            heard.add("setup " + line);
        }

        @Override
        public String turn(String line) {
            heard.add("turn " + line);
            return says;
        }

        @Override
        public void end(String line) {
            heard.add("end " + line);
        }
    }

    private static Bot answering(UnaryOperator<String> turn) {
        return new Bot() {
            @Override
            public void setup(String line) {
                turn.apply(line);
            }

            @Override
            public String turn(String line) {
                return turn.apply(line);
            }

            @Override
            public void end(String line) {
                turn.apply(line);
            }
        };
    }

    private static String faultOf(Bot bot, int lines) {
        Answer answer = new Answer();
        Player player = new InProcessPlayer("p", bot);
        assertEquals(Player.Ending.FAULT, ScriptedBots.ask(player, "t\n", lines, ScriptedBots.FOREVER, answer));
        return answer.fault();
    }

    @Test
    void hearsSetupTurnsAndEndInOrder() {
        Notebook bot = new Notebook("ok");
        Player player = new InProcessPlayer("inside", bot);
        assertEquals("inside", player.name());
        ScriptedBots.tell(player, "hello\n");
        assertEquals("ok", ScriptedBots.reply(player, "one\n"));
        assertEquals("ok", ScriptedBots.reply(player, "two\nlines\n"));
        ScriptedBots.finish(player, "over\n");
        ScriptedBots.finish(player, "over again\n");
        assertEquals(List.of("setup hello", "turn one", "turn two\nlines", "end over"), bot.heard);
    }

    @Test
    void answersAreUtf8AndLinesMayEndLikeOnWindows() {
        assertEquals("\u00e9\u4e16\ud83d\ude80",
            ScriptedBots.reply(new InProcessPlayer("p", new Notebook("\u00e9\u4e16\ud83d\ude80")), "t\n"));
        Player player = new InProcessPlayer("p", new Notebook("a\r\nb\r\n"));
        assertEquals("a\nb", ScriptedBots.answer(player, "t\n", 2).text());
        assertEquals("", ScriptedBots.reply(new InProcessPlayer("p", new Notebook("")), "t\n"));
    }

    @Test
    void anExceptionIsAFault() {
        assertEquals("threw java.lang.IllegalStateException: lost", faultOf(answering(line -> {
            throw new IllegalStateException("lost");
        }), 1));
        assertEquals("threw java.lang.StackOverflowError", faultOf(answering(InProcessPlayerTest::forever), 1));
        Player player = new InProcessPlayer("p", answering(line -> {
            throw new IllegalStateException("at " + line);
        }));
        ScriptedBots.tell(player, "setup\n");
        Answer answer = ScriptedBots.fault(player, "t\n", ScriptedBots.FOREVER);
        assertEquals("threw java.lang.IllegalStateException: at setup", answer.fault());
        assertEquals("asked again after its end", ScriptedBots.fault(player, "t\n", ScriptedBots.FOREVER).fault());
        ScriptedBots.finish(player, "e\n");
    }

    private static String forever(String line) {
        return forever(line + "x").substring(1);
    }

    @Test
    void anExceptionAtTheEndIsNobodysBusiness() {
        Player player = new InProcessPlayer("p", answering(line -> {
            if (line.equals("e")) {
                throw new IllegalStateException("too late");
            }
            return line;
        }));
        assertEquals("t", ScriptedBots.reply(player, "t\n"));
        ScriptedBots.finish(player, "e\n");
    }

    @Test
    void nullOrTheWrongNumberOfLinesIsAFault() {
        assertEquals("answered null", faultOf(new Notebook(null), 1));
        assertEquals("answered 2 lines instead of 1", faultOf(new Notebook("a\nb"), 1));
        assertEquals("answered 1 of 2 lines", faultOf(new Notebook("a"), 2));
        assertEquals("line longer than 65536 bytes", faultOf(new Notebook("x".repeat(65537)), 1));
        Player long1 = new InProcessPlayer("p", new Notebook("x".repeat(65536)));
        assertEquals(65536, ScriptedBots.answer(long1, "t\n", 1).length());
    }

    @Test
    void anAnswerAfterTheLimitIsAFaultAlthoughItCame() {
        long limit = 1_000_000;
        Player player = new InProcessPlayer("p", answering(line -> {
            long end = System.nanoTime() + 2 * limit;
            while (System.nanoTime() < end) {
                Thread.onSpinWait();
            }
            return "late";
        }));
        Answer answer = ScriptedBots.fault(player, "t\n", limit);
        assertTrue(answer.fault().matches("no answer within 1 ms \\(waited [0-9.]+ ms\\)"), answer.fault());
        assertTrue(answer.nanos() >= 2 * limit);
        assertNull(answer.stderr());
    }
}
