package steward.league;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import steward.bot.TimeBasis;
import steward.bot.hold.HoldPolicy;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.text.EnumWords;

/**
 * Settings of a league that a person decides: the content of league.json.
 *
 * @param scene    a shipped scene's name, or a file in the league's folder
 * @param seed     of the first decision; each decision has the next one
 * @param seedFile a file in the league's folder with the seeds that every group plays, in their order; {@code null} for
 *                 numbers in a row
 * @param gauntlet the bot that all others play against, or {@code null} where everyone plays everyone
 * @param adaptive whether those play most whose order is in doubt; otherwise all equally often
 * @param lag      how many decisions back results are known when a decision is made, 1..10000
 * @param factor   by which the scene's time limits are multiplied; {@code POSITIVE_INFINITY} for none
 * @param basis    what the limits are limits of
 * @param hiccups  what becomes of games lost on time on a starved machine
 * @param sandbox  how bots are kept apart: the options of a match that say so
 * @param keepOf   with {@link KeptReplays#LOST}: the bots whose lost games are meant; none for those of any bot
 * @param bots     all of them, in the order of the file
 */
public record LeagueSettings(String scene, long seed, String seedFile, String gauntlet, boolean adaptive, int lag,
                             double factor, TimeBasis basis, Hiccups hiccups, List<String> sandbox, KeptReplays keep,
                             List<String> keepOf, List<LeagueBot> bots) {

    /** The lag of a new league: more than the games that a large machine plays at the same time. */
    public static final int USUAL_LAG = 64;
    public static final int MOST_LAG = 10_000;

    /** The option of a match that names the policy of holding. */
    static final String HOLD = "--hold";

    public LeagueSettings {
        sandbox = List.copyOf(sandbox);
        keepOf = List.copyOf(keepOf);
        bots = List.copyOf(bots);
    }

    /** Returns the settings of a new league without bots. */
    public static LeagueSettings usual(String scene, long seed) {
        return new LeagueSettings(scene, seed, null, null, true, USUAL_LAG, 1, TimeBasis.WALL, Hiccups.REPLAY,
            List.of("--sandbox", "auto"), KeptReplays.FAILED, List.of(), List.of());
    }

    public List<LeagueBot> active() {
        return bots.stream().filter(bot -> !bot.retired()).toList();
    }

    public Optional<LeagueBot> bot(String name) {
        return bots.stream().filter(bot -> bot.name().equals(name)).findFirst();
    }

    public LeagueSettings withBots(List<LeagueBot> others) {
        return new LeagueSettings(scene, seed, seedFile, gauntlet, adaptive, lag, factor, basis, hiccups, sandbox, keep,
            keepOf, others);
    }

    /** Returns these settings with the folders of bots written in another way. */
    LeagueSettings located(UnaryOperator<String> folders) {
        return withBots(bots.stream().map(bot -> bot.in(folders)).toList());
    }

    /** Returns these settings with one bot more, the last. */
    public LeagueSettings with(LeagueBot bot) {
        List<LeagueBot> all = new ArrayList<>(bots);
        all.add(bot);
        return withBots(all);
    }

    /** Returns these settings with a bot replaced, wherever it is named. */
    public LeagueSettings replaced(String name, LeagueBot by) {
        String hero = name.equals(gauntlet) ? by.name() : gauntlet;
        List<String> losers = keepOf.stream().map(each -> each.equals(name) ? by.name() : each).toList();
        return new LeagueSettings(scene, seed, seedFile, hero, adaptive, lag, factor, basis, hiccups, sandbox, keep,
            losers, bots.stream().map(bot -> bot.name().equals(name) ? by : bot).toList());
    }

    /** Returns these settings with other rules of pairing, time and replays, as a new league may be told. */
    public LeagueSettings with(String newGauntlet, double newFactor, KeptReplays newKeep) {
        return new LeagueSettings(scene, seed, seedFile, newGauntlet, adaptive, lag, newFactor, basis, hiccups, sandbox,
            newKeep, keepOf, bots);
    }

    /** The limits in words that differ where a game could end differently: part of a game's name. */
    public String limits() {
        String text = factor == Double.POSITIVE_INFINITY ? "none" : "factor " + factor + " " + basis.word();
        return hold() == HoldPolicy.BURNERS ? text : text + ", hold " + hold().word();
    }

    /** Returns which bots are stopped while others are asked. */
    public HoldPolicy hold() {
        int option = sandbox.indexOf(HOLD);
        return option < 0 ? HoldPolicy.BURNERS : EnumWords.find(List.of(HoldPolicy.values()),
            sandbox.get(option + 1)).orElse(HoldPolicy.BURNERS);
    }

    /** Returns these settings with the seeds of a file, or numbers in a row for {@code null}. */
    public LeagueSettings listing(String file) {
        return new LeagueSettings(scene, seed, file, gauntlet, adaptive, lag, factor, basis, hiccups, sandbox, keep,
            keepOf, bots);
    }

    public LeagueSettings holding(HoldPolicy policy) {
        List<String> words = new ArrayList<>(sandbox);
        int option = words.indexOf(HOLD);
        if (option >= 0) {
            words.subList(option, option + 2).clear();
        }
        words.addAll(List.of(HOLD, policy.word()));
        return new LeagueSettings(scene, seed, seedFile, gauntlet, adaptive, lag, factor, basis, hiccups, words, keep,
            keepOf, bots);
    }

    /** Returns how bots are paired, as it is written in the file. */
    public String pairing() {
        return gauntlet != null ? LeagueReader.GAUNTLET + gauntlet
            : adaptive ? LeagueReader.ADAPTIVE : LeagueReader.ROUND_ROBIN;
    }
}
