package arcomat.diagram;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/** The kinds of text in pictures; sizes are in pixels, as in {@code picture.css}. */
public enum Lettering {
    BOLD(13, true),
    PLAIN(13, false),
    SMALL(11, false);

    /** How wide letters are travels along: pictures are the same where there are no fonts. */
    private static final String TABLE = "/diagram/glyph-widths.txt";

    private static final double UNITS = 2048;

    /** For letters that the table does not know; those of Asia are as wide as high. */
    private static final int UNKNOWN = 2048;

    private static final Map<Integer, Integer> PLAIN_WIDTHS = new HashMap<>();
    private static final Map<Integer, Integer> BOLD_WIDTHS = new HashMap<>();

    static {
        try (InputStream in = Lettering.class.getResourceAsStream(TABLE);
                BufferedReader lines =
                        new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            lines.lines().filter(line -> !line.startsWith("#")).forEach(Lettering::read);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

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
        return Math.ceil(width(text, bold) * size * 10) / 10;
    }

    private static void read(String line) {
        String[] words = line.split(" ");
        Map<Integer, Integer> table = words[0].equals("bold") ? BOLD_WIDTHS : PLAIN_WIDTHS;
        int first = Integer.parseInt(words[1], 16);
        for (int i = 2; i < words.length; i++) {
            if (!words[i].equals("-")) {
                table.put(first + i - 2, Integer.parseInt(words[i]));
            }
        }
    }

    /** In units of the font size. */
    private static double width(String text, boolean bold) {
        Map<Integer, Integer> table = bold ? BOLD_WIDTHS : PLAIN_WIDTHS;
        return text.codePoints().map(c -> table.getOrDefault(c, UNKNOWN)).sum() / UNITS;
    }
}
