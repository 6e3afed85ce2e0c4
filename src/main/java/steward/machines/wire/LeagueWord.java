package steward.machines.wire;

import java.nio.charset.StandardCharsets;
import steward.bot.TimeBasis;
import steward.bot.hold.HoldPolicy;
import steward.contest.Hiccups;
import steward.scene.json.Block;

/** Message of a league to one worker, read strictly; a {@link GameJob} is offered to all. */
public interface LeagueWord {

    /**
     * Acceptance of a worker, and how its games are played.
     *
     * @param version of its program
     * @param rules   what that computes in the scene, as a fingerprint
     * @param jar     digest of the game's jar, {@code null} for a game of the program
     * @param factor  by which the scene's time limits are multiplied
     * @param basis   what they are limits of
     * @param hiccups what becomes of games lost on time on a starved machine
     * @param hold    which bots are stopped while others are asked
     * @param scene   as JSON
     */
    record Welcome(String version, String rules, String jar, double factor, TimeBasis basis, Hiccups hiccups,
                   HoldPolicy hold, String scene)
        implements LeagueWord {

        /** Returns the encoded message. */
        public byte[] bytes() {
            return WireMessage.bytes(new HeaderText().put("type", "welcome").put("version", version).put("rules", rules)
                .put("jar", jar).put("factor", Double.toString(factor)).put("basis", basis.word())
                .put("hiccups", hiccups.word()).put("hold", hold.word()), scene.getBytes(StandardCharsets.UTF_8));
        }
    }

    /** Refusal of a worker. */
    record Refused(String reason) implements LeagueWord {

        /** Returns the encoded message. */
        public byte[] bytes() {
            return WireMessage.bytes(new HeaderText().put("type", "refused").put("reason", reason));
        }
    }

    /**
     * A piece of a bundle.
     *
     * @param bundle its hash
     * @param from   which byte is the first
     * @param bytes  none if the league does not know it; not copied
     */
    record Piece(String bundle, int from, byte[] bytes) implements LeagueWord {
    }

    /**
     * Reads a message.
     *
     * @param source names it in errors
     * @param most   bytes that a bundle can have
     * @throws steward.files.InputException if it is no message
     * @throws steward.scene.json.SceneException if it is none that leagues send
     */
    static LeagueWord read(byte[] bytes, String source, int most) {
        WireMessage message = WireMessage.read(bytes, source);
        Block header = message.header();
        String type = header.text("type");
        LeagueWord word = switch (type) {
            case "welcome" -> welcome(header, message.payload());
            case "refused" -> new Refused(header.text("reason"));
            case "bundle" -> {
                boolean known = header.flag("known", false);
                yield new Piece(header.text("bundle"), header.integer("from", 0, most),
                    known ? message.payload() : new byte[0]);
            }
            default -> throw header.error("type", header.shown("type"), "one that leagues send");
        };
        header.done();
        return word;
    }

    private static Welcome welcome(Block header, byte[] scene) {
        double factor;
        try {
            factor = Double.parseDouble(header.text("factor"));
        } catch (NumberFormatException problem) {
            factor = Double.NaN;
        }
        if (!(factor > 0)) {
            throw header.error("factor", header.shown("factor"), "a number above 0 as a text");
        }
        TimeBasis basis = TimeBasis.of(header.text("basis")).orElseThrow(() ->
            header.error("basis", header.shown("basis"), "wall or cpu"));
        Hiccups hiccups = Hiccups.of(header.text("hiccups")).orElseThrow(() ->
            header.error("hiccups", header.shown("hiccups"), "replay or count"));
        HoldPolicy hold = HoldPolicy.of(header.text("hold")).orElseThrow(() ->
            header.error("hold", header.shown("hold"), "burners, always or never"));
        return new Welcome(header.text("version"), header.text("rules"), header.has("jar") ? header.text("jar") : null,
            factor, basis, hiccups, hold, new String(scene, StandardCharsets.UTF_8));
    }
}
