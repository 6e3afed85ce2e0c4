package steward.machines.wire;

import java.nio.charset.StandardCharsets;
import java.util.List;
import steward.bot.TimeBasis;
import steward.bot.hold.HoldPolicy;
import steward.contest.Hiccups;
import steward.scene.json.Block;
import steward.text.EnumWords;

/** Messages from a league to one worker, parsed strictly; a {@link GameJob} is offered to all workers. */
public interface LeagueWord {

    /**
     * Acceptance of a worker, and how its games are played.
     *
     * @param rules   what that computes in the scene, as a fingerprint
     * @param jar     digest of the game's jar, {@code null} for a game of the program
     * @param factor  by which the scene's time limits are multiplied
     * @param basis   what they are limits of
     * @param hiccups what becomes of games lost on time on a starved machine
     * @param hold    which bots are stopped while others are asked
     * @param scene   as JSON; {@code null} if it is to be fetched, as a bundle is
     * @param bundle  hash of a scene that is to be fetched, or beside a scene of its referee's files; or {@code null}
     * @param size    of the bundle's bytes, or 0
     */
    record Welcome(String version, String rules, String jar, double factor, TimeBasis basis, Hiccups hiccups,
                   HoldPolicy hold, String scene, String bundle, int size)
        implements LeagueWord {

        /** A welcome that has the scene. */
        public Welcome(String version, String rules, String jar, double factor, TimeBasis basis, Hiccups hiccups,
                       HoldPolicy hold, String scene) {
            this(version, rules, jar, factor, basis, hiccups, hold, scene, null, 0);
        }

        /** Returns the welcome with this scene, or none, and a bundle to be fetched. */
        public Welcome with(String text, String hash, int bytes) {
            return new Welcome(version, rules, jar, factor, basis, hiccups, hold, text, hash, bytes);
        }

        public byte[] bytes() {
            HeaderText header = new HeaderText().put("type", "welcome").put("version", version).put("rules", rules)
                .put("jar", jar).put("factor", Double.toString(factor)).put("basis", basis.word())
                .put("hiccups", hiccups.word()).put("hold", hold.word());
            if (bundle != null) {
                header.put("bundle", bundle).put("size", size);
            }
            return WireMessage.bytes(header, (scene == null ? "" : scene).getBytes(StandardCharsets.UTF_8));
        }
    }

    /** Refusal of a worker. */
    record Refused(String reason) implements LeagueWord {

        public byte[] bytes() {
            return WireMessage.bytes(new HeaderText().put("type", "refused").put("reason", reason));
        }
    }

    /**
     * A piece of a bundle or of a long scene.
     *
     * @param from  which byte is the first
     * @param bytes none if the league does not know it; not copied
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
            case "welcome" -> welcome(header, message.payload(), most);
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

    private static Welcome welcome(Block header, byte[] scene, int most) {
        double factor;
        try {
            factor = Double.parseDouble(header.text("factor"));
        } catch (NumberFormatException problem) {
            factor = Double.NaN;
        }
        if (!(factor > 0)) {
            throw header.error("factor", header.shown("factor"), "a number above 0 as a text");
        }
        TimeBasis basis = word(header, "basis", TimeBasis.CHOICES);
        Hiccups hiccups = word(header, "hiccups", List.of(Hiccups.values()));
        HoldPolicy hold = word(header, "hold", List.of(HoldPolicy.values()));
        boolean fetched = header.has("bundle");
        return new Welcome(header.text("version"), header.text("rules"), header.has("jar") ? header.text("jar") : null,
            factor, basis, hiccups, hold, fetched && scene.length == 0 ? null : new String(scene,
            StandardCharsets.UTF_8),
            fetched ? header.text("bundle") : null, fetched ? header.integer("size", 1, most) : 0);
    }

    private static <E extends Enum<E>> E word(Block header, String field, List<E> choices) {
        return EnumWords.find(choices, header.text(field)).orElseThrow(() ->
            header.error(field, header.shown(field), EnumWords.listed(choices)));
    }
}
