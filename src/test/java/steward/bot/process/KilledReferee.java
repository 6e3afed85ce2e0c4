package steward.bot.process;

import java.util.List;
import java.util.stream.Collectors;
import steward.bot.Answer;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.SandboxLevel;

/**
 * A referee to be killed: starts a bot whose script is its first argument, at the level that is its third, prints the
 * processes of the bot, and waits. Outside a sandbox the answer of the bot holds further processes.
 */
final class KilledReferee {

    private KilledReferee() {
    }

    /** Never returns by itself, unless the second argument is {@code exit}. */
    public static void main(String[] arguments) throws InterruptedException {
        BotProcess bot = new BotProcess("bot", new Launch(List.of("sh", "-c", arguments[0]),
            Isolation.at(SandboxLevel.valueOf(arguments[2])), List.of()), BotProcess.DEFAULT_GRACE_MS);
        Answer answer = new Answer();
        byte[] frame = {'a', '\n'};
        bot.ask(frame, frame.length, 1, Long.MAX_VALUE, answer);
        String all = bot.processes().stream().map(String::valueOf).collect(Collectors.joining(" "));
        String said = arguments[2].equals("OFF") ? answer.text() + " " : "";
        System.out.println(said + all + " " + Sentinel.shared().pid());
        if (arguments[1].equals("exit")) {
            System.exit(0);
        }
        Thread.sleep(Long.MAX_VALUE);
    }
}
