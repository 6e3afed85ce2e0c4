package steward.bot.process;

import java.util.List;
import steward.bot.Answer;

/** A referee to be killed: starts a bot whose script is its argument, prints the bot's first answer, and waits. */
final class KilledReferee {

    private KilledReferee() {
    }

    /** Never returns by itself, unless the second argument is {@code exit}. */
    public static void main(String[] arguments) throws InterruptedException {
        BotProcess bot = new BotProcess("bot", List.of("sh", "-c", arguments[0]));
        Answer answer = new Answer();
        byte[] frame = {'a', '\n'};
        bot.ask(frame, frame.length, 1, Long.MAX_VALUE, answer);
        System.out.println(answer.text() + " " + Sentinel.shared().pid());
        if (arguments[1].equals("exit")) {
            System.exit(0);
        }
        Thread.sleep(Long.MAX_VALUE);
    }
}
