package steward.league;

import java.util.List;
import steward.bot.command.BotCommand;

/**
 * A bot as league.json names it.
 *
 * @param name    unlike the others' names
 * @param command {@code [builtin:|json:|codingame:]COMMAND}
 * @param files   what its identity is made of besides the command; {@code null} for every argument that is a file
 * @param random  whether it draws by lot: its games cannot be played again to the bit
 * @param retired whether it plays no more; its games stay
 * @param resumed the decision from which on failures in a row pause it; 0 for all
 */
public record LeagueBot(String name, String command, List<String> files, boolean random, boolean retired,
                        int resumed) {

    /** Copies the list. */
    public LeagueBot {
        files = files == null ? null : List.copyOf(files);
    }

    /** One whose failures all matter. */
    public LeagueBot(String name, String command, List<String> files, boolean random, boolean retired) {
        this(name, command, files, random, retired, 0);
    }

    /** Returns this bot; its failures before a decision do not matter. */
    public LeagueBot resumed(int decision) {
        return new LeagueBot(name, command, files, random, retired, decision);
    }

    /** Returns the bot as it would be typed in a call. */
    public String typed() {
        return name + "=" + command;
    }

    /** @throws IllegalArgumentException if it has no command, or that cannot be split into words */
    public BotCommand parsed() {
        return BotCommand.parse(typed());
    }

    /** Returns this bot under another name. */
    public LeagueBot named(String other) {
        return new LeagueBot(other, command, files, random, retired, resumed);
    }

    /** Returns this bot, to play no more or again. */
    public LeagueBot retired(boolean now) {
        return new LeagueBot(name, command, files, random, now, resumed);
    }
}
