package steward.lab.chart;

import java.awt.Graphics2D;

/** Picture whose colours are chosen later, for a light or a dark page. */
public interface Drawing {

    /** Width in points of its fonts. */
    int width();

    /** Height in points of its fonts. */
    int height();

    /** Paints all but the background. */
    void paint(Graphics2D pen, ChartColours colours);
}
