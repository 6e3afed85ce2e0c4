package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.replay.verify.ForgeryTest.Verdict.ANOTHER_SIGNER;
import static steward.replay.verify.ForgeryTest.Verdict.CUT;
import static steward.replay.verify.ForgeryTest.Verdict.DIFFERS;
import static steward.replay.verify.ForgeryTest.Verdict.PASSES;
import static steward.replay.verify.ForgeryTest.Verdict.REFUSED;
import static steward.replay.verify.ForgeryTest.Verdict.UNSIGNED;
import static steward.replay.verify.ForgeryTest.Verdict.WRONG_SIGNATURE;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.AlteredBot;
import steward.bot.Bot;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.replay.Forge;
import steward.replay.Recorded;
import steward.replay.ReplayException;
import steward.replay.sign.SigningKey;
import steward.scene.json.SceneException;

/**
 * Edits of a replay by a forger that knows the format and computes every hash again, and what verification finds: once
 * for an unsigned replay, once for a signed one. An unsigned one passes only where nothing of the game is touched, or
 * where it is another game altogether: a replay proves that states follow from commands, not who gave them.
 */
@Execution(ExecutionMode.CONCURRENT)
class ForgeryTest {

    enum Verdict {
        /** The reader refuses the file: exit status 2. */
        REFUSED,
        /** A difference is named: exit status 1. */
        DIFFERS,
        /** Verified up to the cut: exit status 1. */
        CUT,
        /** All agrees but the signature: exit status 1. */
        WRONG_SIGNATURE,
        /** Verified, but not signed: exit status 1 with {@code --signed-by}. */
        UNSIGNED,
        /** Verified, but signed by another key: exit status 1 with {@code --signed-by}. */
        ANOTHER_SIGNER,
        /** Verified. */
        PASSES
    }

    private record Forgery(Verdict unsigned, Verdict signed, UnaryOperator<Forge> change) {
    }

    private static final SigningKey KEY = SigningKey.generate();
    private static final int LAST = 12;

    private static Recorded plain;
    private static Recorded signed;
    private static final Map<String, Forgery> FORGERIES = new LinkedHashMap<>();

    /** Twelve turns of three; player 2 fails in turn 5, the others in turn 12. */
    @BeforeAll
    static void playMatches() {
        plain = play(null, 3);
        signed = play(KEY, 3);
        assertTrue(plain.text().contains("\"impacts\"") && plain.text().contains("\"messages\""), plain.text());
        assertEquals(Recorded.whole(LAST), plain.verify());
        assertTrue(signed.verify().verified());
        assertTrue(signed.verify().signature().isBy(KEY.publicKey()));
        results();
        rows();
        signatures();
        turns();
        spellingOfTurns();
        headers();
    }

    private static Recorded play(SigningKey key, long seed) {
        return Recorded.of(TestScenes.changed("walled-race", "\"players\": 2", "\"players\": 3"), seed,
            List.of(stopping(LAST, 1), stopping(LAST, 2), stopping(5, 3)), key);
    }

    private static Bot stopping(int last, long seed) {
        return new AlteredBot(new SeededBot(seed, 0.9), last, answer -> "stop");
    }

    private static void put(String name, Verdict unsigned, Verdict signedToo, UnaryOperator<Forge> change) {
        assertEquals(null, FORGERIES.put(name, new Forgery(unsigned, signedToo, change)), name);
    }

    /** With right hashes, unless the name says otherwise. */
    private static void forge(String name, Verdict verdict, int line, String regex, String with) {
        put(name, verdict, verdict == PASSES ? WRONG_SIGNATURE : verdict, forge -> forge.forge(line, regex, with));
    }

    private static void arrange(String name, Verdict verdict, UnaryOperator<List<String>> change) {
        put(name, verdict, verdict == PASSES ? WRONG_SIGNATURE : verdict, forge -> forge.arrange(change));
    }

    /** The number of the result from the end: the signature may follow. */
    private static UnaryOperator<Forge> result(String regex, String with) {
        return forge -> forge.forge(LAST + 1, regex, with);
    }

    private static void forgeResult(String name, Verdict verdict, String regex, String with) {
        put(name, verdict, verdict == PASSES ? WRONG_SIGNATURE : verdict, result(regex, with));
    }

    private static void results() {
        forgeResult("result: another winner", DIFFERS, "\"rank\":0", "\"rank\":1");
        forgeResult("result: another score", DIFFERS, "\"score\":-?[0-9]+", "\"score\":9");
        forgeResult("result: another ending", DIFFERS, "\"ending\":\"[^\"]*\"", "\"ending\":\"finished after 3 laps\"");
        forgeResult("result: fewer turns", DIFFERS, "\"turns\":12", "\"turns\":11");
        forgeResult("result: another name", DIFFERS, "\"name\":\"P0\"", "\"name\":\"P1\"");
        forgeResult("result: a fault taken away", DIFFERS, "\"name\":\"P2\",\"fault\":\"[^\"]*\"", "\"name\":\"P2\"");
        forgeResult("result: another reason for being out", DIFFERS, "\"out\":\"not JSON", "\"out\":\"no checkpoint");
        forgeResult("result: unknown field", REFUSED, ",\"players\":", ",\"prize\":1,\"players\":");
        forgeResult("result: unknown field of a player", DIFFERS, "\"name\":\"P0\"", "\"name\":\"P0\",\"prize\":1");
        forgeResult("result: unknown field of a place", DIFFERS, "\"rank\":0", "\"prize\":1,\"rank\":0");
        forgeResult("result: doubled field", REFUSED, ",\"players\":", ",\"turns\":12,\"players\":");
        forgeResult("result: doubled field of a player", REFUSED, "\"name\":\"P0\"", "\"name\":\"P0\",\"name\":\"P0\"");
        forgeResult("result: data added before the hash", PASSES, ",\"resultHash\"",
            ",\"data\":{\"a\":\"1\"},\"resultHash\"");
        forgeResult("result: data behind the hash", REFUSED, ",\"times\"", ",\"data\":{\"a\":\"1\"},\"times\"");
        forgeResult("result: stderr behind the hash", REFUSED, ",\"times\"", ",\"stderr\":[\"x\"],\"times\"");
        forgeResult("result: fields moved", REFUSED, "(\"turns\":12),(\"ending\":\"[^\"]*\")", "$2,$1");
        forgeResult("result: blanks", DIFFERS, "\"turns\":12", "\"turns\": 12");
        forgeResult("result: another spelling of a number", DIFFERS, "\"score\":-1", "\"score\":-1.0");
        forgeResult("result: an escaped letter", DIFFERS, "\"name\":\"P0\"", "\"name\":\"\\\\\\\\u00500\"");
        forgeResult("result: no hash", REFUSED, ",\"resultHash\":\"[0-9a-f]*\"", "");
    }

    /** Arranges the rows: an edit, and its expected outcome. */
    private static void rows() {
        arrange("a second result", REFUSED, lines -> insert(lines, LAST + 2, lines.get(LAST + 1)));
        arrange("a result in the middle", REFUSED, lines -> insert(lines, 5, lines.get(LAST + 1)));
        arrange("a result in the middle, nothing behind", DIFFERS, lines -> result(lines.subList(0, 7), lines));
        arrange("a turn behind the result", REFUSED, lines -> insert(lines, LAST + 2, lines.get(LAST)));
        arrange("something behind the end", REFUSED, lines -> insert(lines, lines.size(), "{}"));
        arrange("no result", CUT, lines -> lines.subList(0, LAST + 1));
        arrange("a turn removed", DIFFERS, lines -> without(lines, 6));
        arrange("the first turn removed", DIFFERS, lines -> without(lines, 1));
        arrange("the last turn removed", DIFFERS, lines -> without(lines, LAST));
        arrange("all turns removed", DIFFERS, lines -> keep(lines, 0, LAST + 1));
        arrange("all but the header removed", CUT, lines -> lines.subList(0, 1));
        arrange("a turn doubled", DIFFERS, lines -> insert(lines, 6, lines.get(6)));
        arrange("a turn doubled and numbered anew", DIFFERS, lines -> renumber(insert(lines, 6, lines.get(6))));
        arrange("a turn removed, the others numbered anew", DIFFERS, lines -> renumber(without(lines, 6)));
        arrange("two turns swapped", DIFFERS, lines -> swap(lines, 6, 7));
        arrange("two turns swapped and numbered anew", DIFFERS, lines -> renumber(swap(lines, 6, 7)));
        arrange("an empty line", REFUSED, lines -> insert(lines, 4, ""));
        arrange("a second header", REFUSED, lines -> insert(lines, 1, lines.get(0)));
        arrange("a turn of another match", DIFFERS, lines -> with(lines, 6, play(null, 4).lines().get(6)));
        arrange("another match behind the header", DIFFERS, lines -> behind(lines.get(0), play(null, 4).lines()));
        put("another match altogether", PASSES, UNSIGNED, forge -> forge.arrange(lines -> play(null, 4).lines()));
    }

    private static void signatures() {
        put("the signature taken away", PASSES, CUT, forge -> forge.arrange(lines -> lines.subList(0, LAST + 2)));
        put("another signer altogether", PASSES, ANOTHER_SIGNER,
            forge -> forge.arrange(lines -> play(SigningKey.generate(), 3).lines()));
        put("another signer in the header", PASSES, WRONG_SIGNATURE, forge -> forge.arrange(lines -> with(lines, 0,
            Forge.rehash(lines.get(0).replaceFirst("\"signer\":\"[^\"]*\"", "\"signer\":\""
                + SigningKey.generate().publicKey().text() + "\"")))));
        put("no signer in the header", PASSES, REFUSED, forge -> forge.arrange(lines -> with(lines, 0,
            Forge.rehash(lines.get(0).replaceFirst(",\"signer\":\"[^\"]*\"", "")))));
        put("neither signer nor signature", PASSES, UNSIGNED, forge -> forge.arrange(lines -> with(lines, 0,
            Forge.rehash(lines.get(0).replaceFirst(",\"signer\":\"[^\"]*\"", ""))).subList(0, LAST + 2)));
        put("the signature of another match", REFUSED, WRONG_SIGNATURE, forge -> forge.arrange(lines ->
            insert(new ArrayList<>(lines.subList(0, LAST + 2)), LAST + 2, play(KEY, 4).lines().get(LAST + 2))));
        put("the signature twice", REFUSED, REFUSED, forge -> forge.arrange(lines ->
            insert(insert(lines, LAST + 2, play(KEY, 3).lines().get(LAST + 2)), LAST + 2, lines.get(LAST + 2))));
        put("something else in place of the signature", REFUSED, REFUSED, forge -> forge.arrange(lines ->
            insert(new ArrayList<>(lines.subList(0, LAST + 2)), LAST + 2, "{\"type\":\"praise\"}")));
        put("a field more in the signature", REFUSED, REFUSED, forge -> forge.arrange(lines ->
            insert(new ArrayList<>(lines.subList(0, LAST + 2)), LAST + 2,
                play(KEY, 3).lines().get(LAST + 2).replaceFirst("}$", ",\"times\":{}}"))));
        put("blanks in the signature", REFUSED, WRONG_SIGNATURE, forge -> forge.arrange(lines ->
            insert(new ArrayList<>(lines.subList(0, LAST + 2)), LAST + 2,
                play(KEY, 3).lines().get(LAST + 2).replaceFirst("}$", " }"))));
    }

    private static void turns() {
        forge("turn: another place", DIFFERS, 6, "\"x\":([0-9])(?=[0-9.]*,\"y\":[0-9.]*,\"vx\")", "\"x\":1$1");
        forge("turn: another speed", DIFFERS, 6, "\"vx\":-?[0-9]+", "\"vx\":77");
        forge("turn: another heading in its last digit", DIFFERS, 6, "(\"heading\":-?[0-9.]*)[0-4]\\b", "$17");
        forge("turn: another checkpoint", DIFFERS, 6, "\"passed\":0", "\"passed\":1");
        forge("turn: another count of turns left", DIFFERS, 6, "\"turnsLeft\":\\[[0-9]+", "\"turnsLeft\":[99");
        forge("turn: another hash of the state", DIFFERS, 6, ",\"hash\":\"[0-9a-f]", ",\"hash\":\"g");
        forge("turn: another command", DIFFERS, 8, "\"commands\":\\[\\[\\{\"x\":", "\"commands\":[[{\"x\":1");
        forge("turn: another thrust", DIFFERS, 8, "\"thrust\":[0-9]+", "\"thrust\":3");
        forge("turn: another thrust under the shield, to no effect", PASSES, 6, "\"thrust\":[0-9]+", "\"thrust\":3");
        forge("turn: a command for no thrust spelled otherwise", DIFFERS, 6, "\"x\":([0-9]+),", "\"x\":$1.0,");
        forge("turn: a command taken away", DIFFERS, 6, "\"commands\":\\[\\[.*?\\]", "\"commands\":[null");
        forge("turn: a command for who is out", DIFFERS, 8, "(\\[\\{[^\\]]*\\}\\]),null\\]", "$1,$1]");
        forge("turn: a fault taken away", DIFFERS, 5, "\"faults\":\\[[^\\]]*\\],", "");
        forge("turn: another fault, the result not", DIFFERS, 5, "\"not JSON", "\"too late");
        forge("turn: a fault added", DIFFERS, 6, ",\"outcome\"", ",\"faults\":[\"late\",null,null],\"outcome\"");
    }

    private static void spellingOfTurns() {
        forge("turn: no outcome", REFUSED, 6, "\"outcome\":\\{.*\\},(?=\"(messages|turnHash)\")", "");
        forge("turn: an empty outcome", DIFFERS, 6, "\"outcome\":\\{.*\\},(?=\"(messages|turnHash)\")",
            "\"outcome\":{},");
        forge("turn: unknown field", REFUSED, 6, ",\"outcome\"", ",\"prize\":1,\"outcome\"");
        forge("turn: unknown field of the outcome", DIFFERS, 6, "\"outcome\":\\{", "\"outcome\":{\"prize\":[],");
        forge("turn: unknown field of the state", DIFFERS, 6, "\"state\":\\{", "\"state\":{\"prize\":1,");
        forge("turn: unknown field of a command", DIFFERS, 6, "\"commands\":\\[\\[\\{", "\"commands\":[[{\"prize\":1,");
        forge("turn: doubled field", REFUSED, 6, ",\"outcome\"", ",\"turn\":6,\"outcome\"");
        forge("turn: doubled field of the state", DIFFERS, 6, "\"state\":\\{", "\"state\":{\"bodies\":[],");
        forge("turn: a field behind the hash", REFUSED, 6, ",\"times\"", ",\"stderr\":[\"x\",null,null],\"times\"");
        forge("turn: a field behind the times", REFUSED, 6, "\\}\\}$", "},\"stderr\":[\"x\",null,null]}");
        forge("turn: fields moved", REFUSED, 6, "\"type\":\"turn\",\"turn\":6", "\"turn\":6,\"type\":\"turn\"");
        forge("turn: blanks", DIFFERS, 6, "\"outcome\":", "\"outcome\": ");
        forge("turn: blanks before the end", DIFFERS, 6, "\\}$", " }");
        forge("turn: a wrong message", PASSES, 11, "\"messages\":\\[null,\"", "\"messages\":[null,\"no, ");
        forge("turn: a message of who is out", DIFFERS, 11, "(\"messages\":\\[[^\\]]*),null\\]", "$1,\"me too\"]");
        forge("turn: stderr that nobody wrote", PASSES, 6, ",\"turnHash\"",
            ",\"stderr\":[\"x\",null,null],\"turnHash\"");
        put("turn: a wrong message, the hash as it was", DIFFERS, DIFFERS,
            forge -> forge.replace(11, "\"messages\":\\[null,\"", "\"messages\":[null,\"no, "));
        put("turn: other times", PASSES, PASSES, forge -> forge.replace(6, "\"answerNanos\":\\[[0-9]+",
            "\"answerNanos\":[1"));
        put("turn: no times", PASSES, PASSES, forge -> forge.replace(6, ",\"times\":.*", "}"));
        put("turn: a name twice in times", REFUSED, REFUSED, forge -> forge.replace(6, "\"times\":\\{",
            "\"times\":{\"answerNanos\":[],"));
    }

    private static void headers() {
        forge("header: imported", REFUSED, 0, ",\"scene\":", ",\"imported\":true,\"scene\":");
        forge("header: frames of a server", DIFFERS, 0, ",\"scene\":", ",\"server\":[],\"scene\":");
        forge("header: imported, behind the hash", REFUSED, 0, "\\}$", ",\"imported\":true}");
        put("header: imported, all outcomes emptied", REFUSED, REFUSED, forge -> {
            forge.forge(0, ",\"scene\":", ",\"imported\":true,\"scene\":");
            for (int turn = 1; turn <= LAST; turn++) {
                forge.forge(turn, "\"outcome\":\\{.*\\},(?=\"(messages|turnHash)\")", "\"outcome\":{},");
            }
            return forge;
        });
        put("header: another format", REFUSED, REFUSED, forge -> forge.forge(0, "\"format\":3", "\"format\":2"));
        put("header: a newer format", REFUSED, REFUSED, forge -> forge.forge(0, "\"format\":3", "\"format\":4"));
        put("header: unknown angles", REFUSED, REFUSED, forge -> forge.forge(0, "correctly-rounded", "slide-rule"));
        put("header: no angles", REFUSED, REFUSED, forge -> forge.forge(0, "\"angles\":\"correctly-rounded\",", ""));
        forge("header: another seed", DIFFERS, 0, "\"seed\":\"3\"", "\"seed\":\"4\"");
        forge("header: another spelling of the seed", DIFFERS, 0, "\"seed\":\"3\"", "\"seed\":\"03\"");
        forge("header: another scene", DIFFERS, 0, "\"drag\":0.15", "\"drag\":0.25");
        forge("header: unknown field", REFUSED, 0, ",\"scene\":", ",\"prize\":1,\"scene\":");
        forge("header: unknown field of the scene", REFUSED, 0, "\"drag\":0.15", "\"drag\":0.15,\"prize\":1");
        forge("header: blanks in the scene", DIFFERS, 0, "\"drag\":0.15", "\"drag\": 0.15");
        forge("header: another drawing", DIFFERS, 0, "\"drawing\":\\{\"field\":\\{\"x\":0",
            "\"drawing\":{\"field\":{\"x\":1");
        forge("header: another start", DIFFERS, 0, "\"vx\":0", "\"vx\":1");
        forge("header: one player less", REFUSED, 0, ",\\{\"name\":\"P2\"[^}]*\\}", "");
        forge("header: another name", DIFFERS, 0, "\"name\":\"P0\"", "\"name\":\"Q0\"");
        put("header and result: another name", PASSES, WRONG_SIGNATURE, forge -> forge
            .forge(0, "\"name\":\"P0\"", "\"name\":\"Q0\"").forge(LAST + 1, "\"name\":\"P0\"", "\"name\":\"Q0\""));
        forge("header: another bot", PASSES, 0, "\"bot\":\"P0\"", "\"bot\":\"Q0\"");
        forge("header: other limits", PASSES, 0, "\"timeFactor\":null", "\"timeFactor\":2");
        put("turn and result: another fault", PASSES, WRONG_SIGNATURE, forge -> forge
            .forge(5, "\"not JSON", "\"too late").edit(LAST + 1, line ->
                Forge.rehash(line.replaceAll("(\"out\":|\"fault\":)\"not JSON(?=[^{]*\\}\\])", "$1\"too late"))));
    }

    private static List<String> insert(List<String> lines, int at, String line) {
        lines.add(at, line);
        return lines;
    }

    private static List<String> with(List<String> lines, int at, String line) {
        lines.set(at, line);
        return lines;
    }

    private static List<String> without(List<String> lines, int at) {
        lines.remove(at);
        return lines;
    }

    private static List<String> swap(List<String> lines, int one, int other) {
        Collections.swap(lines, one, other);
        return lines;
    }

    private static List<String> keep(List<String> lines, int first, int second) {
        List<String> kept = new ArrayList<>(List.of(lines.get(first), lines.get(second)));
        kept.addAll(lines.subList(second + 1, lines.size()));
        return kept;
    }

    private static List<String> result(List<String> turns, List<String> lines) {
        List<String> kept = new ArrayList<>(turns);
        kept.addAll(lines.subList(LAST + 1, lines.size()));
        return kept;
    }

    private static List<String> behind(String header, List<String> others) {
        List<String> lines = new ArrayList<>(others);
        lines.set(0, header);
        return lines;
    }

    private static List<String> renumber(List<String> lines) {
        int turn = 1;
        for (int k = 1; k < lines.size(); k++) {
            if (lines.get(k).startsWith("{\"type\":\"turn\"")) {
                lines.set(k, Forge.rehash(lines.get(k).replaceFirst("\"turn\":[0-9]+", "\"turn\":" + turn++)));
            }
        }
        return lines;
    }

    private static Verdict verdict(Recorded replay, UnaryOperator<Forge> change) {
        String forged = change.apply(Forge.of(replay)).text();
        try {
            Verification seen = Recorded.verify(forged);
            boolean wrong = seen.signature().verdict() == SignatureCheck.Verdict.WRONG;
            boolean unsigned = seen.signature().verdict() == SignatureCheck.Verdict.UNSIGNED;
            Verdict passes = replay == plain || seen.signature().isBy(KEY.publicKey()) ? PASSES
                : unsigned ? UNSIGNED : ANOTHER_SIGNER;
            return seen.difference() != null ? DIFFERS : wrong ? WRONG_SIGNATURE : seen.verified() ? passes : CUT;
        } catch (ReplayException | SceneException refusal) {
            assertTrue(refusal.getMessage().startsWith("r.jsonl"), refusal.getMessage());
            return REFUSED;
        }
    }

    @Test
    @Tag("slow")
    void everyForgeryHasItsVerdict() {
        assertTrue(FORGERIES.size() >= 57, "forgeries: " + FORGERIES.size());
        List<String> expected = new ArrayList<>();
        List<String> found = new ArrayList<>();
        FORGERIES.forEach((name, forgery) -> {
            assertDoesNotThrow(() -> forgery.change().apply(Forge.of(plain)), name);
            expected.add(name + ": " + forgery.unsigned() + ", signed " + forgery.signed());
            found.add(name + ": " + verdict(plain, forgery.change()) + ", signed "
                + verdict(signed, forgery.change()));
        });
        assertEquals(String.join("\n", expected), String.join("\n", found));
    }

    /** Without the key nothing passes for signed by it but what was signed: all but the times. */
    @Test
    void whatPassesForSignedIsWhatWasSigned() {
        List<String> passed = new ArrayList<>();
        FORGERIES.forEach((name, forgery) -> {
            if (forgery.signed() == PASSES) {
                byte[] forged = forgery.change().apply(Forge.of(signed)).text().getBytes(StandardCharsets.UTF_8);
                assertEquals(signed.withoutTimes(), new Recorded(forged, null).withoutTimes(), name);
                passed.add(name);
            }
        });
        assertEquals(List.of("turn: other times", "turn: no times"), passed);
    }
}
