package arcomat.world;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The words of one line, read from left to right; {@code #} begins a comment. */
final class Words {
    static final String SYNTAX = "ARC1121";

    private static final Pattern WORD = Pattern.compile("[^\\s#]+|#.*");
    private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_-]{0,15}");

    private final List<Span> words;
    private int position;

    private Words(List<Span> words) {
        this.words = words;
    }

    /**
     * @param line from 1
     */
    static Words ofLine(SourceFile file, int line) {
        int start = file.lineStart(line);
        List<Span> words = new ArrayList<>();
        Matcher matcher = WORD.matcher(file.line(line));
        while (matcher.find()) {
            if (matcher.group().charAt(0) != '#') {
                words.add(file.span(start + matcher.start(), start + matcher.end()));
            }
        }
        return new Words(words);
    }

    boolean isEmpty() {
        return words.isEmpty();
    }

    /** The first word; it stays to be read. */
    Span first() {
        return words.get(0);
    }

    boolean hasNext() {
        return position < words.size();
    }

    /** From the first word to the last. */
    Span whole() {
        return words.get(0).to(words.get(words.size() - 1));
    }

    Span next(String expected) throws Unreadable {
        if (!hasNext()) {
            Span last = words.get(words.size() - 1);
            throw broken(
                    last.file().span(last.end(), last.end()), "here should follow " + expected);
        }
        return words.get(position++);
    }

    /** Reads the word, if it is the next one. */
    boolean take(String word) {
        boolean there = hasNext() && words.get(position).text().equals(word);
        position += there ? 1 : 0;
        return there;
    }

    void expect(String word) throws Unreadable {
        Span next = next("'" + word + "'");
        if (!next.text().equals(word)) {
            throw broken(next, "'" + next.text() + "' stands where '" + word + "' should");
        }
    }

    /** A name as a brick can have: a letter, then letters, digits, - and _; up to 16. */
    Span name(String meaning) throws Unreadable {
        Span word = next(meaning);
        if (!NAME.matcher(word.text()).matches()) {
            throw isNot(word, meaning + ": a letter, then letters, digits, - and _, up to 16");
        }
        return word;
    }

    double number(String meaning, double low, double high) throws Unreadable {
        String expected = "%s, %s to %s".formatted(meaning, shown(low), shown(high));
        Span word = next(expected);
        double number = parsed(word.text());
        if (number >= low && number <= high) { // not a number is neither
            return number;
        }
        throw isNot(word, expected);
    }

    private static double parsed(String text) {
        return text.matches("-?\\d{1,9}(\\.\\d{1,9})?") ? Double.parseDouble(text) : Double.NaN;
    }

    private static String shown(double number) {
        return number == Math.rint(number) ? String.valueOf((long) number) : String.valueOf(number);
    }

    int count(String meaning, int low, int high) throws Unreadable {
        double number = number(meaning, low, high);
        if (number != Math.rint(number)) {
            throw isNot(words.get(position - 1), meaning + ": it has to be whole");
        }
        return (int) number;
    }

    /** One of some words. */
    Span choice(String meaning, List<String> allowed) throws Unreadable {
        String expected = meaning + ": " + String.join(", ", allowed);
        Span word = next(expected);
        if (!allowed.contains(word.text())) {
            throw isNot(word, expected);
        }
        return word;
    }

    void end() throws Unreadable {
        if (hasNext()) {
            Span word = words.get(position);
            throw broken(word, "'" + word.text() + "' is one word too many");
        }
    }

    private static Unreadable isNot(Span word, String expected) {
        return broken(word, "'" + word.text() + "' is not " + expected);
    }

    static Unreadable broken(Span place, String message) {
        return new Unreadable(Diagnostic.error(SYNTAX, place, message));
    }

    /** Gives up reading a line; the parser goes on with the next one. */
    static final class Unreadable extends Exception {
        private static final long serialVersionUID = 1L;

        private final transient Diagnostic finding;

        Unreadable(Diagnostic finding) {
            super(finding.message());
            this.finding = finding;
        }

        Diagnostic finding() {
            return finding;
        }
    }
}
