package steward.replay.page;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Pattern;
import steward.files.Resources;
import steward.files.Sha256;
import steward.json.JsonObject;
import steward.report.Fields;

/**
 * Template of a page, {@code page.html} behind a head that all have, whose places <code>{{name}}</code> are filled with
 * a replay or other data. All modules become one script. The content security policy has the hashes of the script, the
 * chart library and the style sheet, so that nothing else can run.
 */
public final class PageTemplate {

    private static final String OF_REPLAYS = "/steward/view/";
    /** Scripts of the charts and of GIFs, which no one reads: packed in the page, they run by themselves. */
    private static final String LIBRARY = Resources.text(OF_REPLAYS + "uPlot.js") + "\n"
        + Resources.text(OF_REPLAYS + "gifenc.js");
    private static final String PACKED_LIBRARY = ReplayPage.embedded(LIBRARY.getBytes(StandardCharsets.UTF_8));
    /** Colours and letters of all pages, also of those without scripts. */
    public static final String BASE_STYLE = Resources.text(OF_REPLAYS + "base.css");
    private static final String COMMON_STYLE = Resources.text(OF_REPLAYS + "uPlot.css") + BASE_STYLE;
    /** A module for a game whose jar is installed: it calls {@code addLook} of {@code ../view/looks.js}. */
    private static final String LOOK_OF_GAME = "/steward/looks/%s.js";
    private static final Pattern GAME = Pattern.compile("[a-z0-9-]{1,60}");
    /** The place of the replay; everything before it is written first. */
    private static final String REPLAY = "{{replay}}";

    private final String template;
    private final String style;
    private final String script;
    private final Map<String, String> values = new HashMap<>();

    /**
     * Returns the page of a replay.
     *
     * @param title plain text
     * @param game  the id of its game, or {@code null} if any may come; an installed game may bring a module
     */
    static PageTemplate ofReplay(String title, String game) {
        PageTemplate page = new PageTemplate(OF_REPLAYS, title, lookOf(game));
        page.put("details", "");
        return page;
    }

    /**
     * Makes another page.
     *
     * @param folder of the resources {@code page.html}, {@code page.css} and {@code page.js}, with a slash at its end
     * @param title  plain text
     */
    public PageTemplate(String folder, String title) {
        this(folder, title, null);
    }

    private PageTemplate(String folder, String title, String look) {
        template = Resources.text(OF_REPLAYS + "head.html") + Resources.text(folder + "page.html");
        style = COMMON_STYLE + Resources.text(folder + "page.css");
        script = PageScript.of(folder + "page.js", look);
        values.put("title", escape(title));
        values.put("meta", "");
        values.put("style", style);
        values.put("script", script);
        values.put("library", PACKED_LIBRARY);
    }

    private static String lookOf(String game) {
        if (game == null || !GAME.matcher(game).matches()) {
            return null;
        }
        String module = String.format(LOOK_OF_GAME, game);
        return PageTemplate.class.getResource(module) == null ? null : module;
    }

    /**
     * Returns a page that puts several of matches together by itself.
     *
     * @param folder see {@link #PageTemplate(String, String)}
     * @param shell  the page of a match
     * @param data   for its script
     */
    public static byte[] of(String folder, String title, ReplayPage.Shell shell, Fields data) {
        PageTemplate page = new PageTemplate(folder, title);
        page.put("policy", page.policy("'none'", " " + shell.scriptHash(), " " + shell.styleHash()));
        page.put("source", "");
        return page.with(inScript(data));
    }

    /** JSON for a script element: nothing in it can end the element. */
    public static String inScript(Fields data) {
        return JsonObject.text(data::write).replace("<", "\\u003c");
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
        return "default-src 'none'; script-src " + scriptHash() + otherScript + "; style-src " + hash(style)
            + otherStyle
            + "; img-src data:; connect-src " + connect + "; base-uri 'none'; form-action 'none'";
    }

    /** The hashes of its script and of the library, as a policy has them. */
    String scriptHash() {
        return hash(script) + " " + hash(LIBRARY);
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

    /** Returns the page with data in its place. */
    public byte[] with(String data) {
        return (before() + data + after()).getBytes(StandardCharsets.UTF_8);
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

    /** The text that {@link #escape} made HTML of. */
    public static String unescape(String html) {
        return html.replace("&quot;", "\"").replace("&gt;", ">").replace("&lt;", "<").replace("&amp;", "&");
    }

    /** The script of another page: a module with all that it imports. */
    public static String script(String module) {
        return PageScript.of(module, null);
    }

    /** The hash of a style sheet or script, as a policy has it. */
    public static String hash(String text) {
        byte[] digest = Sha256.of(text.getBytes(StandardCharsets.UTF_8));
        return "'sha256-" + Base64.getEncoder().encodeToString(digest) + "'";
    }
}
