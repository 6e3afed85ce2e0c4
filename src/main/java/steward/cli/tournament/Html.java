package steward.cli.tournament;

import steward.files.Resources;
import steward.replay.page.PageTemplate;

/** Parts that all pages of a tournament have. They run no script and fetch nothing. */
final class Html {

    static final String END = "</main></body></html>\n";
    private static final String STYLE = "/steward/tournament/page.css";

    /** The page up to its heading. */
    static String head(String title) {
        String style = Resources.text(STYLE);
        String plain = escape(title);
        return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
            + PageTemplate.hash(style) + "; img-src data:\"><meta name=\"viewport\" content=\"width=device-width, "
            + "initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><style>" + style + "</style><title>" + plain
            + "</title></head><body><main><h1>" + plain + "</h1>";
    }

    /** A text that can stand in a page. */
    static String escape(String text) {
        StringBuilder safe = new StringBuilder();
        PageTemplate.escape(text).codePoints()
            .forEach(c -> safe.appendCodePoint(c < ' ' && c != '\n' && c != '\t' ? 0xFFFD : c));
        return safe.toString();
    }
}
