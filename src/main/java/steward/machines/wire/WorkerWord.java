package steward.machines.wire;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import steward.contest.Attempts;
import steward.scene.json.Block;

/** Messages from a worker to its league, parsed strictly. */
public interface WorkerWord {

    /** Most games that a worker may play at the same time. */
    int MOST_SLOTS = 256;
    /** Most attempts at one game. */
    int MOST_ATTEMPTS = Attempts.MOST;

    /**
     * First message of a worker: its version, rules and capacity.
     *
     * @param bits    what that computes: the keys of the laws of all rungs, or one key for all
     * @param machine what it plays on
     * @param slots   games at the same time
     * @param speed   of its machine, 0 if it does not say
     * @param guests  whether it runs the referees of its leagues
     */
    record Hello(String version, String bits, String machine, int slots, int speed, boolean guests)
        implements WorkerWord {
    }

    /**
     * Request for the next piece of a bundle.
     *
     * @param from which byte is the first
     */
    record Fetch(String bundle, int from) implements WorkerWord {
    }

    /**
     * Result of a job.
     *
     * @param games of the job's in their order; those that are missing at the end were not begun
     */
    record Result(String job, List<Played> games) implements WorkerWord {

        public Result {
            games = List.copyOf(games);
        }

        public byte[] bytes() {
            List<HeaderText> texts = new ArrayList<>();
            List<byte[]> payloads = new ArrayList<>();
            for (Played game : games) {
                List<HeaderText> attempts = IntStream.range(0, game.transcripts().size()).mapToObj(k -> new HeaderText()
                    .put("size", game.transcripts().get(k).length).put("starved", game.starved().get(k))).toList();
                texts.add(new HeaderText().put("attempts", attempts).put("problem", game.problem())
                    .put("discarded", game.discarded()));
                payloads.addAll(game.transcripts());
            }
            return WireMessage.bytes(new HeaderText().put("type", "result").put("job", job).put("games", texts),
                payloads.toArray(byte[][]::new));
        }
    }

    /**
     * Result of a game.
     *
     * @param transcripts compressed, of each attempt
     * @param starved     of each, whether it was played again because others used the processors
     * @param problem     why there is no result, or {@code null}
     * @param discarded   why the last attempt does not count although it has a result, or {@code null}
     */
    record Played(List<byte[]> transcripts, List<Boolean> starved, String problem, String discarded) {

        public Played {
            transcripts = List.copyOf(transcripts);
            starved = List.copyOf(starved);
        }
    }

    /** Report that a bot does not run there. */
    record Unfit(String bundle, String reason) implements WorkerWord {
    }

    /**
     * Refusal of a worker whose program computes other results in the league's scene.
     *
     * @param rules the fingerprint of its results, {@code null} if it has not the league's jar
     * @param jar   digest of its jar of the game, or {@code none}; {@code null} if it has the league's jar
     */
    record Differs(String rules, String jar) implements WorkerWord {
    }

    /** Last message of a worker. */
    record Bye() implements WorkerWord {
    }

    /**
     * Reads a message.
     *
     * @param source names it in errors
     * @param most   bytes that a bundle can have
     * @throws steward.files.InputException if it is no message
     * @throws steward.scene.json.SceneException if it is none that workers send
     */
    static WorkerWord read(byte[] bytes, String source, int most) {
        WireMessage message = WireMessage.read(bytes, source);
        Block header = message.header();
        String type = header.text("type");
        WorkerWord word = switch (type) {
            case "hello" -> new Hello(header.text("version"), header.text("bits"), header.text("machine"),
                header.integer("slots", 1, MOST_SLOTS),
                header.has("speed") ? header.integer("speed", 1, Integer.MAX_VALUE) : 0, header.flag("guests", false));
            case "fetch" -> new Fetch(header.text("bundle"), header.integer("from", 0, most));
            case "result" -> result(header, message.payload());
            case "unfit" -> new Unfit(header.text("bundle"), header.text("reason"));
            case "differs" -> header.has("jar") ? new Differs(null, header.text("jar"))
                : new Differs(header.text("rules"), null);
            case "bye" -> new Bye();
            default -> throw header.error("type", header.shown("type"), "one that workers send");
        };
        header.done();
        return word;
    }

    private static Result result(Block header, byte[] payload) {
        List<Played> games = new ArrayList<>();
        int at = 0;
        for (Block game : header.blocks("games")) {
            if (games.size() == GameJob.MOST_GAMES) {
                throw game.error("another game", "at most " + GameJob.MOST_GAMES);
            }
            List<byte[]> transcripts = new ArrayList<>();
            List<Boolean> starved = new ArrayList<>();
            for (Block attempt : game.blocks("attempts")) {
                if (transcripts.size() == MOST_ATTEMPTS || at == payload.length) {
                    throw attempt.error("size", attempt.shown("size"), "no more attempts: at most " + MOST_ATTEMPTS
                        + ", and the bytes of each");
                }
                int size = attempt.integer("size", 1, payload.length - at);
                starved.add(attempt.flag("starved", false));
                attempt.done();
                transcripts.add(Arrays.copyOfRange(payload, at, at + size));
                at += size;
            }
            games.add(new Played(transcripts, starved, game.has("problem") ? game.text("problem") : null,
                game.has("discarded") ? game.text("discarded") : null));
            game.done();
        }
        if (games.isEmpty()) {
            throw header.error("games", "none", "at least one that was begun");
        }
        return new Result(header.text("job"), games);
    }
}
