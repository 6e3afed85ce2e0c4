package steward.guest;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import steward.bot.isolation.Isolation;
import steward.files.Digested;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.game.TextCodec;
import steward.match.GuestSetup;
import steward.physics.Contacts;
import steward.scene.Plan;
import steward.scene.Scene;
import steward.scene.SceneReader;
import tools.jackson.databind.json.JsonMapper;

/** Game type of all guests, games whose referee is an external program. */
public final class GuestType implements GameType {

    /** Id of the game in scenes. */
    public static final String ID = "guest";

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
        scene.root().done();
        return new Setup(scene, program, Plan.of(scene, new Contacts(1), 1, false, List.of()),
            new RefereeDigest(program), Isolation::usual);
    }

    /** Ends the JVMs of referees that wait for another game. */
    public static void endIdle() {
        ResidentReferees.shared().close();
    }

    private record Setup(Scene scene, GuestProgram program, Plan plan, RefereeDigest files,
                         Supplier<Isolation> isolation) implements GuestSetup, Digested {

        @Override
        public String digest() {
            return files.text();
        }

        @Override
        public GameSetup isolatedBy(Supplier<Isolation> other) {
            return new Setup(scene, program, plan, files, other);
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
            return new GuestJson((GuestGame) game);
        }

        @Override
        public Optional<TextCodec> textCodec(Game game) {
            return Optional.of(new GuestText((GuestGame) game));
        }
    }
}
