package steward.cli.options;

import java.util.Iterator;
import steward.bot.command.BuiltinBots;

/** Names of the bots that come with the program, as {@code --bot} takes them, for help and completion. */
public final class BuiltinBotWords implements Iterable<String> {

    @Override
    public Iterator<String> iterator() {
        return BuiltinBots.installed().names().stream().sorted().map(name -> "builtin:" + name).iterator();
    }
}
