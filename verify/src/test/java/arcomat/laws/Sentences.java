package arcomat.laws;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;

/**
 * Sentences of a page. A row of a table is one; blocks of code and headings of tables are none, and
 * what ends with a colon introduces what follows it and says nothing by itself.
 */
final class Sentences {
    private static final Pattern END = Pattern.compile("(?<=\\.)\\s+(?=[A-Z`*(])");

    private final Predicate<String> sections;
    private final Set<String> sentences = new LinkedHashSet<>();
    private final StringBuilder paragraph = new StringBuilder();
    private boolean wanted;
    private boolean code;
    private String lastRow = "";

    private Sentences(Predicate<String> sections) {
        this.sections = sections;
    }

    /**
     * @param sections by their headings
     */
    static Set<String> of(String page, Predicate<String> sections) {
        Sentences found = new Sentences(sections);
        page.lines().map(String::strip).forEach(found::read);
        found.endParagraph();
        return found.sentences;
    }

    private void read(String line) {
        boolean fence = line.startsWith("```");
        if (fence || code) {
            code ^= fence;
            endParagraph();
        } else if (line.startsWith("#")) {
            endParagraph();
            wanted = sections.test(line.replaceFirst("#+ ", ""));
        } else if (line.startsWith("|")) {
            readRow(line);
        } else {
            readText(line);
        }
    }

    private void readRow(String row) {
        endParagraph();
        if (row.matches("\\|[-|]+")) {
            sentences.remove(lastRow); // the heading
        } else if (wanted) {
            sentences.add(row);
        }
        lastRow = row;
    }

    private void readText(String line) {
        boolean item = line.matches("(\\*|\\d+\\.) .*");
        if (line.isEmpty() || item) {
            endParagraph();
        }
        paragraph.append(item ? line.replaceFirst("(\\*|\\d+\\.) ", "") : line).append(' ');
    }

    private void endParagraph() {
        if (wanted) {
            Arrays.stream(END.split(paragraph.toString().strip()))
                    .filter(each -> !each.isEmpty() && !each.endsWith(":"))
                    .forEach(sentences::add);
        }
        paragraph.setLength(0);
    }
}
