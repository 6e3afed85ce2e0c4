package steward.contest;

import java.util.List;
import steward.bot.Player;
import steward.bot.command.Program;
import steward.bot.isolation.Isolation;
import steward.contest.Contest.Entrant;

/** Starter of a match's players from bots: as processes, or inside the JVM for measurements. */
public interface BotStarter {

    /**
     * A player that is not started yet.
     *
     * @param others the programs of the other bots, which it must not see
     */
    Player player(Entrant entrant, Isolation isolation, List<Program> others);
}
