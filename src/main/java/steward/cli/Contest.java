package steward.cli;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import steward.bot.BotCommand;
import steward.bot.BotProcess;
import steward.bot.Player;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/**
 * A scene and the bots that are to play in it, checked: any number of matches can be played, also at the same time.
 *
 * @param setup      the scene with its game
 * @param entrants   the bots, in the order of the call
 * @param time       how long they may take
 * @param timeFactor by which the scene's limits are multiplied; {@code POSITIVE_INFINITY} for no deadlines
 */
record Contest(GameSetup setup, List<Entrant> entrants, TimeControl time, double timeFactor) {

    /**
     * A bot.
     *
     * @param name  unlike the others' names
     * @param bot   as it was named in the call
     * @param words the program to start and its arguments
     */
    record Entrant(String name, String bot, List<String> words) {
    }

    /**
     * Reads the scene and finds the bots; nothing is started.
     *
     * @throws InputException                if the bots are not as many as the players, or one cannot be started
     * @throws steward.scene.SceneException if the scene cannot be used
     */
    static Contest of(String scene, List<String> bots, double timeFactor) {
        GameSetup setup = openScene(scene);
        int players = setup.scene().players();
        if (bots.size() != players) {
            throw new InputException("found " + Words.count(bots.size(), "bot") + ", expected "
                + Words.count(players, "bot") + ", one --bot for each player of the scene \"" + setup.scene().name()
                + "\"");
        }
        return new Contest(setup, entrants(bots), timeControl(setup, timeFactor), timeFactor);
    }

    /** Opens a scene by its path or shipped name. */
    static GameSetup openScene(String scene) {
        SceneText text = SceneFiles.load(scene);
        return Games.types().open(text.text(), text.source());
    }

    private static TimeControl timeControl(GameSetup setup, double factor) {
        if (factor == Double.POSITIVE_INFINITY) {
            return TimeControl.UNLIMITED;
        }
        try {
            return TimeControl.of(setup.scene().time(), factor);
        } catch (IllegalArgumentException problem) {
            throw new InputException(problem.getMessage());
        }
    }

    private static List<Entrant> entrants(List<String> bots) {
        List<BotCommand> commands = new ArrayList<>();
        List<String> names = new ArrayList<>();
        List<List<String>> words = new ArrayList<>();
        for (String bot : bots) {
            try {
                BotCommand command = BotCommand.parse(bot);
                if (command.prefix() == BotCommand.Prefix.CODINGAME) {
                    throw new InputException("bot '" + bot + "': found the prefix codingame:, but this version "
                        + "speaks JSON alone");
                }
                commands.add(command);
                names.add(command.displayName());
                words.add(command.resolve());
            } catch (IllegalArgumentException problem) {
                throw new InputException(problem.getMessage());
            }
        }
        List<Entrant> entrants = new ArrayList<>();
        for (int k = 0; k < bots.size(); k++) {
            String name = names.get(k);
            boolean shared = names.indexOf(name) != names.lastIndexOf(name);
            entrants.add(new Entrant(shared ? name + "-" + k : name, commands.get(k).toString(), words.get(k)));
        }
        return entrants;
    }

    String sceneName() {
        return setup.scene().name();
    }

    /** Which bot plays as a player when the bots have moved up by {@code rotation} places. */
    int entrantOf(int player, int rotation) {
        return (player + rotation) % entrants.size();
    }

    /**
     * Plays a match.
     *
     * @param rotation  by how many places the bots move up
     * @param recording where the replay goes, or {@code null}; left open
     * @param follower  is told of every turn after it has been recorded
     * @throws RuntimeException if it could not be brought to a result
     */
    MatchResult play(long seed, int rotation, OutputStream recording, MatchListener follower)
            throws InterruptedException {
        List<Player> players = new ArrayList<>();
        for (int player = 0; player < entrants.size(); player++) {
            Entrant entrant = entrants.get(entrantOf(player, rotation));
            players.add(new BotProcess(entrant.name(), entrant.words()));
        }
        MatchListener listener = recording == null ? follower
            : new Followers(new ReplayWriter(recording, header(seed, rotation)), follower);
        return new Referee(setup, seed, players, time, listener).play();
    }

    private ReplayHeader header(long seed, int rotation) {
        List<String> names = new ArrayList<>();
        List<String> bots = new ArrayList<>();
        for (int player = 0; player < entrants.size(); player++) {
            Entrant entrant = entrants.get(entrantOf(player, rotation));
            names.add(entrant.name());
            bots.add(entrant.bot());
        }
        return new ReplayHeader(setup.scene().gameId(), setup.scene().json(), seed, names, bots, timeFactor);
    }
}
