package steward.replay.page;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The page around a replay or other data: {@code page.html} with its places, written <code>{{name}}</code>, filled in.
 * All scripts become one; the content security policy names it and the style sheet by their hashes, so that nothing
 * else can run.
 */
public final class PageTemplate {

    private static final String OF_REPLAYS = "/steward/view/";
    /** In the order in which they need each other. */
    private static final List<String> SCRIPTS = List.of("match.js", "notes.js", "theme.js", "shapes.js", "stage.js",
        "podrace.js", "searchrace.js", "meanmax.js", "fantasticbits.js", "pokerchiprace.js", "playback.js",
        "timeline.js", "chart.js",
        "panels.js", "page.js");
    /** The place of the replay; everything before it is written first. */
    private static final String REPLAY = "{{replay}}";

    private final String folder;
    private final String template;
    private final String style;
    private final String script;
    private final Map<String, String> values = new HashMap<>();

    /** The page of a replay. */
    PageTemplate(String title) {
        this(OF_REPLAYS, SCRIPTS, title);
    }

    /**
     * Another page.
     *
     * @param folder  of the resources {@code page.html}, {@code page.css} and the scripts, with a slash at its end
     * @param scripts in the order in which they need each other
     * @param title   plain text
     */
    public PageTemplate(String folder, List<String> scripts, String title) {
        this.folder = folder;
        template = load("page.html");
        style = load("page.css");
        script = script(scripts);
        values.put("title", escape(title));
        values.put("style", style);
        values.put("script", script);
    }

    /** Writes bytes into the page. */
    public interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /** Fills a place with HTML. */
    public void put(String name, String html) {
        values.put(name, html);
    }

    /** Forbids everything but this style and this script; {@code connect} says what may be connected to. */
    public String policy(String connect) {
        return policy(connect, "", "");
    }

    /**
     * Returns the policy that allows also the script and the style of another page, by their hashes as a policy has
     * them.
     */
    public String policy(String connect, String otherScript, String otherStyle) {
        return "default-src 'none'; script-src " + hash(script) + otherScript + "; style-src " + hash(style)
            + otherStyle
            + "; img-src data:; connect-src " + connect + "; base-uri 'none'; form-action 'none'";
    }

    /** The hash of its script, as a policy has it. */
    String scriptHash() {
        return hash(script);
    }

    /** The hash of its style sheet, as a policy has it. */
    String styleHash() {
        return hash(style);
    }

    /** Returns the text before the data. */
    String before() {
        return fill(template.substring(0, template.indexOf(REPLAY)));
    }

    /** Returns the text behind the data. */
    String after() {
        return fill(template.substring(template.indexOf(REPLAY) + REPLAY.length()));
    }

    /** Writes the page, and the data in its place. */
    public void write(OutputStream html, Content replay) throws IOException {
        html.write(before().getBytes(StandardCharsets.UTF_8));
        replay.writeTo(html);
        html.write(after().getBytes(StandardCharsets.UTF_8));
        html.flush();
    }

    /** One pass, so that nothing in a value is taken for a place. */
    private String fill(String part) {
        StringBuilder filled = new StringBuilder();
        int from = 0;
        for (int open = part.indexOf("{{"); open >= 0; open = part.indexOf("{{", from)) {
            int close = part.indexOf("}}", open);
            filled.append(part, from, open).append(values.get(part.substring(open + 2, close)));
            from = close + 2;
        }
        return filled.append(part, from, part.length()).toString();
    }

    /** Text as HTML, in an element or in a quoted attribute. */
    public static String escape(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;");
    }

    /** All scripts in one scope of their own. */
    private String script(List<String> scripts) {
        StringBuilder all = new StringBuilder("(() => {\n'use strict';\n");
        for (String name : scripts) {
            all.append(load(name)).append('\n');
        }
        return all.append("})();\n").toString();
    }

    private String load(String name) {
        try (InputStream in = PageTemplate.class.getResourceAsStream(folder + name)) {
            if (in == null) {
                throw new IllegalStateException("the program is not whole: " + folder + name + " is missing");
            }
            // A browser reads every line end as \n, and takes hashes of what it reads.
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
        } catch (IOException problem) {
            throw new IllegalStateException("the program is not whole: " + folder + name, problem);
        }
    }

    private static String hash(String text) {
        try {
            byte[] digest = MessageDigest.getInstance("SHA-256").digest(text.getBytes(StandardCharsets.UTF_8));
            return "'sha256-" + Base64.getEncoder().encodeToString(digest) + "'";
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException(impossible);
        }
    }
}
