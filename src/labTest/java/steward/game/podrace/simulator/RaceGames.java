package steward.game.podrace.simulator;

import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import steward.bots.PodBot;
import steward.bots.Racer;
import steward.game.GameJson;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodState;
import steward.game.podrace.Recordings;
import steward.game.podrace.protocol.PodRaceType;
import steward.json.JsonNumbers;
import steward.numerics.SplitMix64;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Whole races of the engine for the tests of {@code src/python}, in a file: {@code gradle raceGames -Pgames=5000}.
 * Players are the bot racer, aimed ones with shields and boosts, and random ones; now and then one is put out by a
 * fault, with or without commands that stand before it. Rules are live and contest by turns.
 *
 * <p>Little-endian, a game: the word 1, its seed, 1 for the rules of the contest, the number of checkpoints, their x
 * and y. A turn: the word 2, for each pod x, y and thrust, for each player 1 if he is put out before it and 1 if he is
 * racer; after it for each pod x, y, vx, vy, heading, shield timer, boost left, passed; turns left of both, the hash.
 * The end: the word 3, the ending (1 finished, 2 all others out, 3 all out, 4 most turns), both ranks. Words and
 * numbers have 8 bytes. At the end of the file the word 0, then 10,000 radians with StrictMath's cosine and sine.
 */
public final class RaceGames {

    private static final int PODS = 4;
    private static final int PLAYERS = 2;
    private static final int ANGLES = 10_000;
    private static final int FAULTY_GAMES = 8;
    private static final double FAULT = 0.02;
    private static final int LARGEST_RECORD = 1024;
    private static final List<String> ENDINGS = List.of("finished", "all others", "all are", "at most");

    /** Sort of player. */
    private enum Sort { RACER, AIMED, RANDOM }

    private final ByteBuffer record = ByteBuffer.allocate(LARGEST_RECORD).order(ByteOrder.LITTLE_ENDIAN);
    private final DataOutputStream out;
    private long turns;

    private RaceGames(DataOutputStream out) {
        this.out = out;
    }

    /** @param words {@code --games N --seed N --out FILE} */
    public static void main(String[] words) throws IOException {
        Map<String, String> options = new HashMap<>();
        for (int k = 0; k + 1 < words.length; k += 2) {
            options.put(words[k], words[k + 1]);
        }
        int games = Integer.parseInt(options.getOrDefault("--games", "250"));
        long seed = Long.parseLong(options.getOrDefault("--seed", "1"));
        Path file = Path.of(options.get("--out"));
        Files.createDirectories(file.toAbsolutePath().getParent());
        try (DataOutputStream out = new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(file)))) {
            RaceGames written = new RaceGames(out);
            for (int game = 0; game < games; game++) {
                written.play(seed + game);
            }
            written.angles(new SplitMix64(seed));
            System.out.println(games + " games, " + written.turns + " turns in " + file);
        }
    }

    private void play(long seed) throws IOException {
        SplitMix64 random = new SplitMix64(seed ^ Long.MIN_VALUE);
        boolean contest = random.nextInt(2) == 1;
        PodRaceType.PodRaceSetup setup = contest ? Recordings.contest() : Recordings.official();
        PodRace race = setup.create(seed);
        record.putLong(1).putLong(seed).putLong(contest ? 1 : 0).putLong(race.checkpoints().length);
        for (double[] place : race.checkpoints()) {
            record.putDouble(place[0]).putDouble(place[1]);
        }
        send();
        GameJson frames = setup.codec(race);
        Sort[] sorts = new Sort[PLAYERS];
        PodBot[] racers = new PodBot[PLAYERS];
        for (int player = 0; player < PLAYERS; player++) {
            sorts[player] = Sort.values()[random.nextInt(Sort.values().length)];
            racers[player] = new Racer();
            racers[player].setup(frame(frames, player, true));
        }
        boolean faulty = random.nextInt(FAULTY_GAMES) == 0;
        while (!race.isOver()) {
            int[] faults = new int[PLAYERS];
            for (int player = 0; player < PLAYERS; player++) {
                faults[player] = faulty && random.nextDouble() < FAULT ? 1 : 0;
                int pods = faults[player] == 0 ? 2 : random.nextInt(2);
                if (sorts[player] == Sort.RACER && faults[player] == 0) {
                    byte[] answer = racers[player].turn(frame(frames, player, false))
                        .getBytes(StandardCharsets.US_ASCII);
                    if (frames.readAnswer(player, answer, answer.length) != null) {
                        throw new IllegalStateException("racer's answer is refused");
                    }
                } else {
                    for (int pod = 2 * player; pod < 2 * player + pods; pod++) {
                        command(race, pod, sorts[player] == Sort.RANDOM, random);
                    }
                }
            }
            turn(race, faults, sorts);
        }
        int ending = 1;
        while (!race.ending().startsWith(ENDINGS.get(ending - 1))) {
            ending++;
        }
        int[] ranks = race.ranks();
        record.putLong(3).putLong(ending).putLong(ranks[0]).putLong(ranks[1]);
        send();
    }

    private static String frame(GameJson frames, int player, boolean setup) {
        ByteArrayOutputStream text = new ByteArrayOutputStream();
        try (JsonGenerator json = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), text)) {
            json.writeStartObject();
            json.writeStringProperty("type", setup ? "setup" : "turn");
            if (setup) {
                json.writeNumberProperty("player", player);
                frames.writeSetup(json, player);
            } else {
                frames.writeTurn(json, player);
            }
            json.writeEndObject();
        }
        return text.toString(StandardCharsets.UTF_8);
    }

    /** Gives a pod a random command, or one that aims at its checkpoint or at another pod. */
    private static void command(PodRace race, int pod, boolean random, SplitMix64 chance) {
        int drawn = chance.nextInt(40);
        int thrust = drawn == 0 ? PodRace.SHIELD : drawn == 1 ? PodRace.BOOST
            : random ? chance.nextInt(0, 200) : drawn < 6 ? 100 : 200;
        if (random) {
            race.command(pod, chance.nextInt(16_000), chance.nextInt(9_000), thrust);
            return;
        }
        PodState state = race.pod(pod);
        int other = (pod + 1 + race.turn() / 20) % PODS;
        double[] next = race.checkpoints()[race.nextCheckpoint(pod)];
        boolean chases = pod % 2 == 1 && race.turn() % 60 > 30;
        double x = chases ? race.pod(other).x() : next[0];
        double y = chases ? race.pod(other).y() : next[1];
        race.command(pod, x - 3 * state.vx() + chance.nextInt(-20, 20) / 8.0, y - 3 * state.vy(), thrust);
    }

    private void turn(PodRace race, int[] faults, Sort[] sorts) throws IOException {
        record.putLong(2);
        for (int pod = 0; pod < PODS; pod++) {
            record.putDouble(race.targetX(pod)).putDouble(race.targetY(pod)).putDouble(race.thrust(pod));
        }
        for (int player = 0; player < PLAYERS; player++) {
            record.putLong(faults[player]).putLong(sorts[player] == Sort.RACER ? 1 : 0);
            if (faults[player] == 1) {
                race.eliminate(player, "a fault");
            }
        }
        race.play();
        turns++;
        for (int pod = 0; pod < PODS; pod++) {
            PodState state = race.pod(pod);
            record.putDouble(state.x()).putDouble(state.y()).putDouble(state.vx()).putDouble(state.vy())
                .putDouble(state.heading()).putDouble(state.shieldTimer()).putDouble(state.boostLeft() ? 1 : 0)
                .putDouble(state.passed());
        }
        record.putDouble(race.turnsLeft(0)).putDouble(race.turnsLeft(1)).putLong(race.hash());
        send();
    }

    private void angles(SplitMix64 random) throws IOException {
        record.putLong(0);
        send();
        for (int k = 0; k < ANGLES; k++) {
            double degrees = k < 361 ? k : 360 * random.nextDouble();
            double angle = StrictMath.toRadians(degrees);
            record.putDouble(angle).putDouble(StrictMath.cos(angle)).putDouble(StrictMath.sin(angle));
            send();
        }
    }

    private void send() throws IOException {
        out.write(record.array(), 0, record.position());
        record.clear();
    }
}
