package steward.bots;

import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.TimeControl;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/** Plays bundled bots against each other inside this JVM, without deadlines. */
public final class BundledBotMatches {

    private BundledBotMatches() {
    }

    /** A shipped scene. */
    static GameSetup scene(String name) {
        return scene(name, text -> text);
    }

    /** A shipped scene with its text changed. */
    static GameSetup scene(String name, UnaryOperator<String> change) {
        SceneText scene = SceneFiles.load("config/scenes/" + name + ".json");
        return new GameTypes(List.of(new PodRaceType())).open(change.apply(scene.text()), scene.source());
    }

    /** The official scene for other numbers of pods and players, over after 60 turns. */
    static GameSetup crowd(int pods, int players) {
        return scene("mad-pod-racing", text -> text
            .replace("\"players\": 2", "\"players\": " + players)
            .replace("\"perPlayer\": 2", "\"perPlayer\": " + pods)
            .replace("\"maximumTurns\": 500", "\"maximumTurns\": 60"));
    }

    /** Plays one match, one bot per player. */
    static MatchResult play(GameSetup scene, long seed, PodBot... bots) {
        return play(scene, seed, new MatchListener() { }, bots);
    }

    /** Plays one match with a listener. */
    static MatchResult play(GameSetup scene, long seed, MatchListener listener, PodBot... bots) {
        return play(scene, seed, listener, Stream.of(bots).map(BundledBotMatches::asBot).toArray(Bot[]::new));
    }

    /** Plays one match, one bot of any sort per player. */
    static MatchResult play(GameSetup scene, long seed, Bot... bots) {
        return play(scene, seed, new MatchListener() { }, bots);
    }

    private static MatchResult play(GameSetup scene, long seed, MatchListener listener, Bot... bots) {
        List<InProcessPlayer> players = Stream.of(bots).map(bot -> new InProcessPlayer("bot", bot)).toList();
        try {
            return new Referee(scene, seed, players, TimeControl.UNLIMITED, listener).play();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(interrupted);
        }
    }

    /** The bot as the referee knows it. */
    public static Bot asBot(PodBot bot) {
        return new Bot() {
            @Override
            public void setup(String line) {
                bot.setup(line);
            }

            @Override
            public String turn(String line) {
                return bot.turn(line);
            }
        };
    }
}
