package steward.machines.serve;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import steward.bot.isolation.Isolation;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.bundle.Bundle;
import steward.machines.check.GzipText;
import steward.machines.check.TranscriptWriter;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;
import steward.match.Protocol;
import steward.scene.RungLaw;

/** A worker that speaks the protocol and means harm, or one that has bad luck. */
public final class HostileWorker {

    /** What it does with its games. */
    public enum Way {
        /** Plays three games as it should, and then answers for the bots as others would. */
        ANSWERS,
        /** Plays three games as it should, and then reports other states than those that follow. */
        STATES,
        /** Plays three games as it should, and then changes a command, and not the states that it reports. */
        COMMANDS,
        /** Says that a bot was late, after a time that it says was shorter than the limit. */
        EARLY,
        /** Says that a bot was late, after a time that has not passed. */
        LATE,
        /** Takes as many games as it is given and never answers. */
        KEEPS,
        /** Says that it cannot play, at each game. */
        FAILS
    }

    /** Programs that it plays with. */
    public interface Bots {
        /** Returns the command of a bot, honest or another's. */
        String command(String name, boolean honest);
    }

    private final Way way;
    private final String scene;
    private final Bots bots;
    private int games;
    private int jobs;

    /** @param scene of the league, a file */
    public HostileWorker(Way way, String scene, Bots bots) {
        this.way = way;
        this.scene = scene;
        this.bots = bots;
    }

    /** Returns how many jobs it was given. */
    public int jobs() {
        return jobs;
    }

    /** Plays until it is over. @throws BrokenException if the broker ends the connection */
    public void play(BrokerClient client, BooleanSupplier over) throws BrokenException, InterruptedException {
        hello(client, "hostile", 4);
        List<BrokerClient.Taker> kept = new ArrayList<>();
        BrokerClient.Taker taker = client.taker(List.of());
        kept.add(taker);
        try {
            while (!over.getAsBoolean()) {
                byte[] bytes = taker.take(500);
                if (bytes == null) {
                    continue;
                }
                jobs++;
                GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                if (way == Way.KEEPS) {
                    taker = client.taker(List.of());
                    kept.add(taker);
                    continue;
                }
                List<WorkerWord.Played> played = new ArrayList<>();
                for (GameJob.Game game : job.games()) {
                    played.add(played(game));
                }
                taker.finish(new WorkerWord.Result(job.id(), played).bytes());
            }
        } finally {
            kept.forEach(BrokerClient.Taker::close);
        }
    }

    private WorkerWord.Played played(GameJob.Game game) throws InterruptedException {
        if (way == Way.FAILS) {
            return new WorkerWord.Played(List.of(), List.of(), "no space left on device", null);
        }
        boolean honest = games++ < 3;
        byte[] transcript = switch (way) {
            case EARLY -> late(game, "1");
            case LATE -> late(game, "600000000000");
            case STATES -> changed(transcript(game, true), text -> honest ? text
                : text.replaceFirst("\"states\":\"[0-9a-f]", "\"states\":\"x"));
            case COMMANDS -> changed(transcript(game, true), text -> honest ? text
                : text.replaceFirst("\"thrust\":(100|0)", "\"thrust\":50"));
            default -> transcript(game, honest || way != Way.ANSWERS);
        };
        return new WorkerWord.Played(List.of(transcript), List.of(false), null, null);
    }

    private byte[] transcript(GameJob.Game game, boolean honest) throws InterruptedException {
        List<String> commands = game.seats().stream().map(seat -> seat.name() + "="
            + bots.command(seat.name(), honest)).toList();
        return transcript(scene, commands, game.seed(), 1);
    }

    /** Plays a game. @param factor of its time limits */
    static byte[] transcript(String scene, List<String> commands, long seed, double factor)
            throws InterruptedException {
        Contest contest = Contest.of(Games.open(scene), commands, Protocol.JSON, factor)
            .isolatedBy(() -> Isolation.OFF);
        TranscriptWriter transcript = new TranscriptWriter(commands, "off");
        contest.play(seed, 0, null, transcript);
        return transcript.compressed();
    }

    /** The game as if the first player had missed the first deadline, with the hash of states that follows. */
    private byte[] late(GameJob.Game game, String nanos) throws InterruptedException {
        List<String> commands = new ArrayList<>(List.of("never=codingame:sleep 5"));
        game.seats().stream().skip(1).forEach(seat -> commands.add(seat.name() + "="
            + bots.command(seat.name(), true)));
        return changed(transcript(scene, commands, game.seed(), 0.001), text -> text.replaceFirst(
            "\"answerNanos\":\\[[0-9]+", "\"answerNanos\":[" + nanos));
    }

    private static byte[] changed(byte[] transcript, UnaryOperator<String> change) {
        try {
            return GzipText.compressed(change.apply(new String(GzipText.bytes(transcript), StandardCharsets.UTF_8))
                .getBytes(StandardCharsets.UTF_8));
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    /** Says that it is there, with so many games at a time. */
    static void hello(BrokerClient client, String machine, int slots) throws BrokenException {
        client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "1")
            .put("bits", RungLaw.keys()).put("machine", machine).put("slots", slots)));
    }
}
