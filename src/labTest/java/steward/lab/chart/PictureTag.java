package steward.lab.chart;

/** Tag that shows a page's reader the picture that suits it, of two files in the page's folder. */
public final class PictureTag {

    private PictureTag() { }

    public static String of(String light, String dark, String words) {
        return "<picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"" + dark + "\"><img alt=\"" + words
            + "\" src=\"" + light + "\"></picture>";
    }
}
