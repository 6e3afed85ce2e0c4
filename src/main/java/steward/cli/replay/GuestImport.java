package steward.cli.replay;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import steward.bot.command.CommandLine;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.codingame.recording.RecordingImport;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.guest.GuestType;
import steward.guest.RefereeFault;
import steward.match.GuestSetup;
import steward.replay.ReplayReader;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
import steward.report.Fields;
import steward.text.TextFormat;

/**
 * Import of a game whose referee is that of a scene. The game is played and compared. If a frame differs, it is also
 * played at the other league levels, and in the other scenes that were named.
 *
 * @param text   of the recording
 * @param source its name
 * @param scenes as they were typed; the first one is played
 * @param level  the league level, or {@code null} for that of the scene
 */
record GuestImport(Streams streams, String text, String source, List<String> scenes, Integer level) {

    /** The user has named the scenes, and with them their referees. */
    private static final GameTypes TYPES = Games.types(true);

    /** Attempts at other levels and scenes; one more ends it. */
    private static final int MOST_ATTEMPTS = 40;

    /**
     * A game as it was played.
     *
     * @param name     of scene and level, for people
     * @param replay   of it; empty if the referee failed
     * @param compared {@code null} if the referee failed
     * @param views    as they were compared
     */
    private record Played(String name, RecordingImport.Imported imported, byte[] replay, Verification compared,
                          ViewComparison views) {

        boolean isSame() {
            return compared != null && compared.agrees() && imported.note() == null;
        }

        String found() {
            ReplayDifference difference = compared == null ? null : compared.difference();
            return name + (compared == null ? ": the referee fails" : difference == null ? ": no difference"
                : ": differs from " + (difference.turn() == 0 ? "the start" : "turn " + difference.turn()) + " on");
        }
    }

    /**
     * Plays the game in the first scene, compares it, and prints what was found.
     *
     * @param write takes the replay
     * @param json  whether one JSON object is printed in place of words; {@code null} for nothing
     * @param out   where the replay goes, as it was typed
     * @throws InputException if the recording or the scene cannot be used
     */
    int run(Consumer<byte[]> write, Boolean json, String out) throws InterruptedException {
        GuestSetup scene = open(scenes.get(0));
        GuestSetup first = level == null ? scene : at(scene, level);
        Played played;
        List<String> others = new ArrayList<>();
        try {
            played = play(first, "");
            write.accept(played.replay);
            if (!played.isSame()) {
                others.addAll(others(first));
            }
        } catch (RefereeFault fault) {
            throw new FailedException(fault.getMessage());
        } finally {
            GuestType.endIdle();
        }
        if (json == null) {
            return played.isSame() ? ExitStatus.DONE : ExitStatus.FAILED;
        }
        if (json) {
            Json.print(streams, Fields.of("turns", played.imported.turns(), "ending", played.imported.ending(),
                "replay", out, "equal", played.views.values(), "difference", played.compared.difference(),
                "note", played.imported.note(), "notCompared", played.views.notCompared(), "others", others));
        } else {
            streams.out().println("imported: " + TextFormat.count(played.imported.turns(), "turn") + ", "
                + (played.imported.ending() == null ? "and there the recording ends" : played.imported.ending()));
            new VerifyReport(streams.out(), streams.outColour(), true, null, null, null, false, played.views)
                .print(reader(played.replay), played.compared);
            if (played.imported.note() != null) {
                streams.out().println("not played: " + played.imported.note());
            }
            others.forEach(other -> streams.out().println("  " + other));
            streams.out().println("  steward replay " + CommandLine.quote(List.of(out))
                + " --verify --run-referee   compares it again");
        }
        return played.isSame() ? ExitStatus.DONE : ExitStatus.FAILED;
    }

    /** Plays the game at other levels of the scene, and in the other scenes at all of theirs; a sentence on each. */
    private List<String> others(GuestSetup first) throws InterruptedException {
        List<String> found = new ArrayList<>();
        for (String scene : scenes) {
            GuestSetup setup = open(scene);
            int levels = setup.level() == 0 ? 0 : Math.max(setup.levels(), setup.level());
            for (int each = Math.min(1, levels); each <= levels && found.size() < MOST_ATTEMPTS; each++) {
                GuestSetup at = each == 0 ? setup : at(setup, each);
                if (!at.scene().json().equals(first.scene().json())) {
                    found.add(tried(at, (scenes.size() == 1 ? "" : scene + " ") + (each == 0 ? "as it is"
                        : "--league-level " + each)));
                }
            }
        }
        return found;
    }

    private String tried(GuestSetup setup, String name) throws InterruptedException {
        try {
            return play(setup, name).found();
        } catch (RefereeFault fault) {
            return new Played(name, null, new byte[0], null, null).found();
        }
    }

    private static GuestSetup open(String scene) {
        GameSetup setup = Games.open(scene);
        if (setup instanceof GuestSetup guest) {
            return guest;
        }
        throw new InputException("--scene: found a scene of " + setup.scene().gameId() + ", which Steward computes, "
            + "expected one of an adopted referee: of other games the views tell which one it is");
    }

    private static GuestSetup at(GuestSetup setup, int level) {
        return (GuestSetup) TYPES.inLeague(setup, level);
    }

    private Played play(GuestSetup setup, String name) throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        try {
            RecordingImport.Imported imported = RecordingImport.ofGuest(text, source, TYPES, setup).write(replay);
            byte[] bytes = replay.toByteArray();
            ViewComparison views = new ViewComparison();
            return new Played(name, imported, bytes, Verification.of(reader(bytes), TYPES, views), views);
        } catch (IllegalArgumentException problem) {
            throw new InputException(problem.getMessage());
        }
    }

    private ReplayReader reader(byte[] replay) {
        return new ReplayReader(new ByteArrayInputStream(replay), source);
    }
}
