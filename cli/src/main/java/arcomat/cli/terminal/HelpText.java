package arcomat.cli.terminal;

import java.util.ArrayList;
import java.util.List;

/**
 * Paragraphs and examples of a help, in lines that fit. Lines that begin with blanks are examples:
 * they stay lines, and one that is too long goes on as a shell would read it.
 */
public final class HelpText {
    private static final String CONTINUED = "      ";

    /** Between an example and what it shows. */
    private static final String GAP = "   ";

    private final int width;
    private final List<String> fitted = new ArrayList<>();
    private final StringBuilder paragraph = new StringBuilder();

    private HelpText(int width) {
        this.width = width;
    }

    public static String[] fit(String[] lines, int width) {
        HelpText text = new HelpText(width);
        for (String line : lines) {
            text.add(line);
        }
        text.endParagraph();
        return text.fitted.toArray(String[]::new);
    }

    private void add(String line) {
        if (!line.isBlank() && !line.startsWith(" ")) {
            paragraph.append(paragraph.isEmpty() ? "" : " ").append(line);
            return;
        }
        endParagraph();
        int gap = line.indexOf(GAP, line.length() - line.stripLeading().length());
        if (line.length() <= width) {
            fitted.add(line);
        } else if (gap > 0) {
            addBroken(line.substring(0, gap), " \\");
            addBroken(CONTINUED + line.substring(gap).strip(), "");
        } else {
            addBroken(line, " \\");
        }
    }

    private void endParagraph() {
        if (!paragraph.isEmpty()) {
            String text = paragraph.toString();
            paragraph.setLength(0);
            while (text.length() > width) {
                int end = end(text, width);
                fitted.add(text.substring(0, end));
                text = text.substring(end).strip();
            }
            addUnlessEmpty(text);
        }
    }

    /**
     * @param mark at the end of lines that go on
     */
    private void addBroken(String line, String mark) {
        String rest = line;
        while (rest.length() > width) {
            int end = end(rest, width - mark.length());
            String more = rest.substring(end).strip();
            fitted.add(rest.substring(0, end) + (more.isEmpty() ? "" : mark));
            rest = more.isEmpty() ? "" : CONTINUED + more;
        }
        addUnlessEmpty(rest);
    }

    private void addUnlessEmpty(String line) {
        if (!line.isEmpty()) {
            fitted.add(line);
        }
    }

    /** The last blank behind a word; the end where there is none. */
    private static int end(String text, int most) {
        int blank = text.lastIndexOf(' ', most);
        return blank > 0 && !text.substring(0, blank).isBlank() ? blank : text.length();
    }
}
