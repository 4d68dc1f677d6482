package arcomat.diagram;

import java.util.Locale;

/** The kinds of text in pictures; sizes are in pixels, as in {@code picture.css}. */
public enum Lettering {
    BOLD(13, true),
    PLAIN(13, false),
    SMALL(11, false);

    private static final double LEADING = 1.3;
    private static final double ASCENT = 0.95;

    private final double size;
    private final boolean bold;

    Lettering(double size, boolean bold) {
        this.size = size;
        this.bold = bold;
    }

    /** The class that styles it. */
    public String style() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** From line to line. */
    public double lineHeight() {
        return Math.ceil(size * LEADING);
    }

    /** From the top of a line to the foot of its letters. */
    double ascent() {
        return size * ASCENT;
    }

    /** Rounded up to a tenth of a pixel. */
    public double width(String text) {
        return Math.ceil(GlyphWidths.of(text, bold) * size * 10) / 10;
    }
}
