package steward.cli.tournament;

import steward.files.Resources;
import steward.replay.page.PageTemplate;
import steward.replay.page.ReplayPage;

/** Shared parts of a tournament's HTML pages, which load nothing from elsewhere. */
final class Html {

    static final String END = "</main></body></html>\n";
    private static final String STYLE = PageTemplate.BASE_STYLE + Resources.text("/steward/tournament/page.css");
    private static final String SCRIPT = PageTemplate.script("/steward/tournament/author.js");

    /** The page without scripts up to its heading. */
    static String head(String title) {
        return head(title, "", "");
    }

    /** The page up to its heading, with a script that puts pages of matches together. */
    static String headWithReplays(String title, ReplayPage.Shell shell) {
        return head(title, "; script-src " + PageTemplate.hash(SCRIPT) + " " + shell.scriptHash(),
            " " + shell.styleHash());
    }

    /** The end of a page with replays. @param data JSON for a script element */
    static String endWithReplays(String data) {
        return "<script type=\"application/json\" id=\"data\">" + data + "</script><script>" + SCRIPT
            + "</script>" + END;
    }

    private static String head(String title, String scripts, String styles) {
        String plain = escape(title);
        return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            + "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
            + PageTemplate.hash(STYLE) + styles + scripts + "; img-src data:\"><meta name=\"viewport\" content=\"width="
            + "device-width, initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><style>" + STYLE + "</style><title>"
            + plain + "</title></head><body><main><h1>" + plain + "</h1>";
    }

    /** A text that can stand in a page. */
    static String escape(String text) {
        StringBuilder safe = new StringBuilder();
        PageTemplate.escape(text).codePoints()
            .forEach(c -> safe.appendCodePoint(c < ' ' && c != '\n' && c != '\t' ? 0xFFFD : c));
        return safe.toString();
    }
}
