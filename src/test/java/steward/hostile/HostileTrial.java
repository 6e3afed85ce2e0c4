package steward.hostile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import steward.bot.isolation.SandboxLevel;
import steward.bot.process.JavaProcess;
import steward.cli.Cli;
import steward.cli.Main;
import steward.hostile.Attack.Effect;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * One match of a hostile bot against an honest one, and what is left of it. It is played by the program itself, within
 * this JVM, or in one of its own where the referee may be ended.
 */
final class HostileTrial {

    /** With what a hostile bot exits that has seen or done what it must not. */
    private static final String DONE_IT = "exited with status 77 before answering";
    private static final int SEED = 7;

    private final Programs programs;
    private final Path folder;
    /** A duel of few turns, in which it shows whether an earlier match has left something. */
    private final Path next;
    private final Path temporary = Path.of(System.getProperty("java.io.tmpdir"));

    /** @param folder for replays */
    HostileTrial(Programs programs, Path folder) throws IOException {
        this.programs = programs;
        this.folder = folder;
        next = Files.writeString(folder.resolve("next.json"), Files.readString(Path.of("config/scenes/duel.json"))
            .replaceFirst("\"maximumTurns\": [0-9]+", "\"maximumTurns\": 10"));
    }

    /**
     * Result of a trial.
     *
     * @param effect   what has become of the attack
     * @param verdict  the fault of the hostile bot, {@code none}, or what became of the referee
     * @param millis   how long the match took
     * @param problems what should not be so
     */
    record Finding(Effect effect, String verdict, long millis, List<String> problems) {
    }

    Finding play(Attack attack, SandboxLevel level) throws IOException, InterruptedException {
        List<String> problems = new ArrayList<>();
        String mark = "hostile" + Long.toUnsignedString(System.nanoTime(), 36);
        Path replay = folder.resolve(mark + ".jsonl");
        Set<String> filesBefore = Machine.temporaryFiles(temporary);
        int descriptorsBefore = Machine.descriptors();
        long threadsBefore = Machine.threads();
        List<String> call = new ArrayList<>(call("duel", level, replay, attack.factor(),
            programs.command(attack, mark), programs.honest(mark)));
        if (attack.limited() && level != SandboxLevel.OFF) {
            call.addAll(List.of("--memory", "64M"));
        }
        long start = System.nanoTime();
        Cli played = attack.referee() ? inItsOwn(call) : Cli.run(call);
        long millis = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - start);

        boolean expectLeft = level == SandboxLevel.OFF && attack.off() == Effect.ESCAPES;
        boolean left = expectLeft ? Machine.await(() -> !Machine.marked(mark).isEmpty())
            : !Machine.await(() -> Machine.marked(mark).isEmpty());
        if (!Machine.end(mark)) {
            problems.add("processes cannot be killed: " + Machine.marked(mark));
        }
        String verdict = verdict(played);
        boolean harmed = played.status() != 0 || verdict.equals(DONE_IT) || opponentFailed(played);
        Effect effect = left ? Effect.ESCAPES : harmed ? Effect.SUCCEEDS : Effect.HELD;
        if (effect == Effect.HELD && !verdict.matches(attack.verdict())) {
            problems.add("verdict " + verdict + ", expected " + attack.verdict() + "\n" + played.err());
        }
        Effect expected = level == SandboxLevel.OFF ? attack.off() : Effect.HELD;
        if (effect != expected) {
            problems.add("it " + effect.word() + ", expected: " + expected.word() + "; " + verdict + "\n"
                + played.err());
        }
        Set<String> files = new TreeSet<>();
        boolean none = Machine.await(() -> {
            files.clear();
            files.addAll(Machine.temporaryFiles(temporary));
            files.removeAll(filesBefore);
            return files.isEmpty();
        });
        if (!none) {
            problems.add("files are left: " + files);
        }
        if (!Machine.await(() -> Machine.descriptors() <= descriptorsBefore + 2)) {
            problems.add("descriptors: " + descriptorsBefore + " before, " + Machine.descriptors() + " after");
        }
        if (!Machine.await(() -> Machine.threads() <= Math.max(threadsBefore, 4))) {
            problems.add("threads: " + threadsBefore + " before, " + Machine.threads() + " after");
        }
        if (!attack.word().equals("changes-replay") || effect == Effect.HELD) {
            verify(replay, played.status() != 0, problems);
        }
        return new Finding(effect, verdict, millis, problems);
    }

    /** An undisturbed match: its last hash, or what went wrong. Equal after every attack. */
    String undisturbed(SandboxLevel level) throws IOException {
        Path replay = folder.resolve("next.jsonl");
        Files.deleteIfExists(replay);
        Cli played = Cli.run(call(next.toString(), level, replay, 20, programs.honest("a"), programs.honest("b")));
        if (played.status() != 0) {
            return played.status() + " " + played.out() + played.err();
        }
        List<String> lines = Files.readAllLines(replay);
        String last = lines.get(lines.size() - 2);
        int hash = last.indexOf("\"hash\":");
        return last.substring(hash, Math.min(last.length(), hash + 26));
    }

    private static List<String> call(String scene, SandboxLevel level, Path replay, int factor, String bot,
                                     String other) {
        return List.of("match", "--scene", scene, "--seed", "" + SEED, "--sandbox", level.word(), "--time-factor",
            "" + factor, "--json", "--out", replay.toString(), "--bot", bot, "--bot", other);
    }

    private Cli inItsOwn(List<String> call) throws IOException, InterruptedException {
        List<String> words = JavaProcess.words(List.of("-Djava.io.tmpdir=" + temporary), Main.class, call);
        Path out = folder.resolve("out");
        Path err = folder.resolve("err");
        Process process = new ProcessBuilder(words).redirectOutput(out.toFile()).redirectError(err.toFile()).start();
        if (!process.waitFor(2, TimeUnit.MINUTES)) {
            process.destroyForcibly();
        }
        return new Cli(process.waitFor(), Files.readString(out), Files.readString(err));
    }

    private static JsonNode players(Cli played) {
        return played.out().startsWith("{") ? JsonMapper.shared().readTree(played.out()).path("players") : null;
    }

    private static String verdict(Cli played) {
        JsonNode players = players(played);
        if (players == null) {
            return "the referee ended with status " + played.status();
        }
        JsonNode fault = players.path(0).path("fault");
        return fault.isString() ? fault.stringValue() : Attacks.NONE;
    }

    private static boolean opponentFailed(Cli played) {
        JsonNode players = players(played);
        return players != null && players.path(1).path("fault").isString();
    }

    /** @param cut whether the match may have been broken off */
    private void verify(Path replay, boolean cut, List<String> problems) {
        List<String> call = new ArrayList<>(List.of("replay", replay.toString(), "--verify", "--quiet"));
        if (cut) {
            call.add("--partial");
        }
        Cli verified = Cli.run(call);
        if (verified.status() != 0) {
            problems.add("the replay does not verify: " + verified.out() + verified.err());
        }
    }
}
