package arcomat.diagram;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;

/**
 * How wide letters are, from a table that travels along: pictures are the same on every machine,
 * also where there are no fonts.
 */
final class GlyphWidths {
    private static final String TABLE = "/diagram/glyph-widths.txt";
    private static final double UNITS = 2048;

    /** For letters that the table does not know; those of Asia are as wide as high. */
    private static final int UNKNOWN = 2048;

    private static final Map<Integer, Integer> PLAIN = new HashMap<>();
    private static final Map<Integer, Integer> BOLD = new HashMap<>();

    static {
        try (InputStream in = GlyphWidths.class.getResourceAsStream(TABLE);
                BufferedReader lines =
                        new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            lines.lines().filter(line -> !line.startsWith("#")).forEach(GlyphWidths::read);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private GlyphWidths() {}

    private static void read(String line) {
        String[] words = line.split(" ");
        Map<Integer, Integer> table = words[0].equals("bold") ? BOLD : PLAIN;
        int first = Integer.parseInt(words[1], 16);
        for (int i = 2; i < words.length; i++) {
            if (!words[i].equals("-")) {
                table.put(first + i - 2, Integer.parseInt(words[i]));
            }
        }
    }

    /** In units of the font size. */
    static double of(String text, boolean bold) {
        Map<Integer, Integer> table = bold ? BOLD : PLAIN;
        return text.codePoints().map(c -> table.getOrDefault(c, UNKNOWN)).sum() / UNITS;
    }
}
