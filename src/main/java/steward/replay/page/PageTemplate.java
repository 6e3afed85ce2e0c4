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
 * The page around a replay: {@code page.html} with its places, written <code>{{name}}</code>, filled in. All scripts
 * become one; the content security policy names it and the style sheet by their hashes, so that nothing else can run.
 */
final class PageTemplate {

    private static final String FOLDER = "/steward/view/";
    /** In the order in which they need each other. */
    private static final List<String> SCRIPTS = List.of("match.js", "notes.js", "theme.js", "shapes.js", "stage.js",
        "podrace.js", "searchrace.js", "meanmax.js", "pokerchiprace.js", "playback.js", "timeline.js", "chart.js",
        "panels.js", "page.js");
    /** The place of the replay; everything before it is written first. */
    private static final String REPLAY = "{{replay}}";

    private final String template = load("page.html");
    private final String style = load("page.css");
    private final String script = script();
    private final Map<String, String> values = new HashMap<>();

    PageTemplate(String title) {
        values.put("title", escape(title));
        values.put("style", style);
        values.put("script", script);
    }

    /** Writes bytes into the page. */
    interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /** Fills a place with HTML. */
    void put(String name, String html) {
        values.put(name, html);
    }

    /** Forbids everything but this style and this script; {@code connect} says what may be connected to. */
    String policy(String connect) {
        return "default-src 'none'; script-src " + hash(script) + "; style-src " + hash(style)
            + "; img-src data:; connect-src " + connect + "; base-uri 'none'; form-action 'none'";
    }

    void write(OutputStream html, Content replay) throws IOException {
        int middle = template.indexOf(REPLAY);
        html.write(fill(template.substring(0, middle)).getBytes(StandardCharsets.UTF_8));
        replay.writeTo(html);
        html.write(fill(template.substring(middle + REPLAY.length())).getBytes(StandardCharsets.UTF_8));
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
    static String escape(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;");
    }

    /** All scripts in one scope of their own. */
    private static String script() {
        StringBuilder all = new StringBuilder("(() => {\n'use strict';\n");
        for (String name : SCRIPTS) {
            all.append(load(name)).append('\n');
        }
        return all.append("})();\n").toString();
    }

    private static String load(String name) {
        try (InputStream in = PageTemplate.class.getResourceAsStream(FOLDER + name)) {
            if (in == null) {
                throw new IllegalStateException("the program is not whole: " + FOLDER + name + " is missing");
            }
            // A browser reads every line end as \n, and takes hashes of what it reads.
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).replace("\r\n", "\n");
        } catch (IOException problem) {
            throw new IllegalStateException("the program is not whole: " + FOLDER + name, problem);
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
