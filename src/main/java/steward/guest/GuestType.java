package steward.guest;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import steward.bot.isolation.Isolation;
import steward.files.Digested;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.game.ServerView;
import steward.game.TextCodec;
import steward.game.ViewWriter;
import steward.match.GuestSetup;
import steward.physics.Contacts;
import steward.scene.Plan;
import steward.scene.Scene;
import steward.scene.SceneReader;
import steward.text.TextFormat;
import tools.jackson.databind.json.JsonMapper;

/** Game type of all guests, games whose referee is an external program. */
public final class GuestType implements GameType {

    /** Id of the game in scenes. */
    public static final String ID = "guest";

    private static final int SHOWN = 60;

    private final boolean trusted;

    /** @param trusted whether programs are run that replays or leagues of others name */
    public GuestType(boolean trusted) {
        this.trusted = trusted;
    }

    @Override
    public boolean isTrusted() {
        return trusted;
    }

    @Override
    public String id() {
        return ID;
    }

    @Override
    public String inLeague(Scene scene, int league) {
        if (!scene.root().block(SceneReader.REFEREE).contains("classPath")) {
            throw scene.root().error("referee", "a command", "a classPath with a league level");
        }
        return scene.root().json(SceneReader.REFEREE, Map.of("leagueLevel", Integer.toString(league)));
    }

    @Override
    public Optional<ViewWriter> viewWriter() {
        return Optional.of(new GuestViews());
    }

    @Override
    public GameSetup open(Scene scene) {
        if (scene.players() == 0) {
            throw scene.root().error("players", "0", "1.." + MOST_PLAYERS + ", as many as its referee is for");
        }
        GuestProgram program = GuestProgram.read(scene.root());
        if (program.isSolo() && scene.players() != 1) {
            throw scene.root().error("players", Integer.toString(scene.players()),
                "1: the mode of its referee is " + GuestProgram.SOLO);
        }
        if ((!program.tests().criterion().isEmpty() || program.tests().lowerIsBetter()) && scene.players() != 1) {
            throw scene.root().error("players", Integer.toString(scene.players()), "1: the criterion is of a game for "
                + "one");
        }
        int levels = scene.root().block(SceneReader.REFEREE).integer(GuestProgram.LEVELS, 1, GuestProgram.MOST_LEVEL,
            1);
        scene.root().done();
        return new Setup(scene, program, levels, Plan.of(scene, new Contacts(1), 1, false, List.of()),
            new RefereeDigest(program), Isolation::usual);
    }

    /** Ends the JVMs of referees that wait for another game. */
    public static void endIdle() {
        ResidentReferees.shared().close();
    }

    private record Setup(Scene scene, GuestProgram program, int levels, Plan plan, RefereeDigest files,
                         Supplier<Isolation> isolation) implements GuestSetup, Digested {

        @Override
        public String digest() {
            return files.text();
        }

        @Override
        public GameSetup isolatedBy(Supplier<Isolation> other) {
            return new Setup(scene, program, levels, plan, files, other);
        }

        @Override
        public List<String> words() {
            return isOnClassPath() ? program.classPath().stream().map(entry -> Path.of(entry).toString()).toList()
                : program.command();
        }

        @Override
        public boolean isOnClassPath() {
            return program.isResident();
        }

        @Override
        public int level() {
            return program.level();
        }

        @Override
        public ServerView.Start begin(List<String> input) {
            List<String> lines = input.stream().map(String::strip).filter(line -> !line.isEmpty()).toList();
            if (tests() > 0) {
                return new ServerView.Start(scene.json(), program.tests().seed(lines));
            }
            Map<String, String> properties = new TreeMap<>(program.properties());
            for (String line : lines) {
                int at = line.indexOf('=');
                if (at < 1) {
                    throw new IllegalArgumentException("found \"" + TextFormat.beginning(line, SHOWN)
                        + "\", expected lines KEY=VALUE");
                }
                properties.put(line.substring(0, at), line.substring(at + 1));
            }
            long seed;
            try {
                seed = Long.parseLong(properties.getOrDefault("seed", ""));
            } catch (NumberFormatException noNumber) {
                throw new IllegalArgumentException("found " + (properties.containsKey("seed") ? "the seed "
                    + TextFormat.beginning(properties.get("seed"), SHOWN) : "no seed") + ", expected seed=N");
            }
            properties.remove("seed");
            return new ServerView.Start(properties.equals(program.properties()) ? scene.json()
                : scene.root().json(SceneReader.REFEREE, Map.of("properties",
                    JsonMapper.shared().writeValueAsString(properties))), seed);
        }

        @Override
        public int tests() {
            return program.tests().tests().size();
        }

        @Override
        public String sceneWith(List<String> words) {
            return scene.root().json(SceneReader.REFEREE, Map.of(isOnClassPath() ? "classPath" : "command",
                JsonMapper.shared().writeValueAsString(words)));
        }

        @Override
        public List<String> check() {
            if (program.missing() != null) {
                throw scene.root().block(SceneReader.REFEREE).error(program.isResident() ? "classPath" : "command",
                    "\"" + program.missing() + "\"", program.isResident() ? "folders and jars that are there"
                    : "a program that is there");
            }
            return List.of();
        }

        @Override
        public Game create(long seed) {
            return recorded(seed, null);
        }

        @Override
        public Game recorded(long seed, Supplier<byte[]> outcome) {
            return new GuestGame(program, scene.players(), seed, isolation, outcome);
        }

        @Override
        public Pilot pilot(Pilot.Aim aim) {
            throw new UnsupportedOperationException("nothing is known of a guest's commands");
        }

        @Override
        public GameJson codec(Game game) {
            return new GuestCodec((GuestGame) game);
        }

        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new GuestCodec((GuestGame) game));
        }
    }
}
