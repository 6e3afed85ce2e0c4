package steward.replay.page;

/**
 * What a page of a replay may have besides the replay.
 *
 * @param sent        UTF-8 text of one line per turn, from turn 0 on: a JSON array with the lines that each player was
 *                    sent, as one string or {@code null}; {@code null} for none
 * @param site        address under which the page will be found, for previews of links; {@code null} for none
 * @param description one sentence for previews; used with {@code site}
 */
public record PageExtras(byte[] sent, String site, String description) {

    /** Nothing more than the replay. */
    public static final PageExtras NONE = new PageExtras(null, null, null);

    /** Elements of the head: title, description and picture for previews of links, if there is an address. */
    String meta(String title) {
        if (site == null) {
            return "";
        }
        String picture = site.replaceFirst("(\\.html?)?$", ".png");
        return property("og:type", "website") + property("og:title", title) + property("og:description", description)
            + property("og:url", site) + property("og:image", picture) + named("twitter:card", "summary_large_image")
            + named("description", description);
    }

    private static String property(String name, String content) {
        return "<meta property=\"" + name + "\" content=\"" + PageTemplate.escape(content) + "\">\n";
    }

    private static String named(String name, String content) {
        return "<meta name=\"" + name + "\" content=\"" + PageTemplate.escape(content) + "\">\n";
    }
}
