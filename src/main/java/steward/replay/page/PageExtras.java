package steward.replay.page;

import steward.game.GameTypes;

/**
 * Optional parts of a replay's page besides the replay.
 *
 * @param types       games with which the match is played again, so that the page has what bots were sent; {@code null}
 *                    if it shall not have it
 * @param site        address under which the page will be found, for previews of links; {@code null} for none
 * @param description one sentence for previews; used with {@code site}
 */
public record PageExtras(GameTypes types, String site, String description) {

    /** Nothing more than the replay. */
    public static final PageExtras NONE = new PageExtras(null, null, null);

    /** With what bots were sent. */
    public static PageExtras of(GameTypes types) {
        return new PageExtras(types, null, null);
    }

    /** Elements of the head: title, description and picture for previews of links, if there is an address. */
    String meta(String title) {
        if (site == null) {
            return "";
        }
        return property("og:type", "website") + property("og:title", title) + property("og:description", description)
            + property("og:url", site) + property("og:image", picture(site))
            + named("twitter:card", "summary_large_image") + named("description", description);
    }

    /** The address of the picture of a page: in the same folder, {@code race.png} for {@code race.html}. */
    public static String picture(String site) {
        String path = site.replaceFirst("[?#].*$", "");
        boolean isHost = path.indexOf('/', path.indexOf("://") + "://".length()) < 0;
        return isHost || path.endsWith("/") ? path + (isHost ? "/" : "") + "index.png"
            : path.replaceFirst("(\\.html?)?$", ".png");
    }

    private static String property(String name, String content) {
        return "<meta property=\"" + name + "\" content=\"" + PageTemplate.escape(content) + "\">\n";
    }

    private static String named(String name, String content) {
        return "<meta name=\"" + name + "\" content=\"" + PageTemplate.escape(content) + "\">\n";
    }
}
