package steward.lab.chart;

import java.awt.Graphics2D;

/** A picture before it has colours. */
public interface Drawing {

    /** Width in points of its fonts. */
    int width();

    /** Height in points of its fonts. */
    int height();

    /** Paints all but the background. */
    void paint(Graphics2D pen, ChartColours colours);
}
