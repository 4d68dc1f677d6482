package arcomat.world;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The words of one line, read from left to right; {@code #} begins a comment. Between quotation
 * marks there may be blanks in a word.
 */
public final class Words {
    static final String SYNTAX = "ARC1121";

    /** No floor is larger, in mm. */
    static final double FAR = 1_000_000;

    private static final Pattern WORD = Pattern.compile("(?:\"[^\"]*\"|[^\\s#])+|#.*");

    /** A bracket that is not closed; quotation marks may stand around others. */
    private static final Pattern BRACKETS = Pattern.compile("[^(\"]*\\((?:\"[^\"]*\"|[^)\"])*");

    private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9_-]{0,15}");
    private static final Pattern PARAMETER = Pattern.compile("[A-Za-z][A-Za-z0-9_]*");

    private final List<Word> words;
    private final String code;
    private int position;

    private Words(List<Word> words, String code) {
        this.words = words;
        this.code = code;
    }

    /**
     * The words of a world as they are written.
     *
     * @param line from 1
     */
    static Words ofLine(SourceFile file, int line) {
        return ofLine(file, line, SYNTAX);
    }

    /**
     * The words as they are written.
     *
     * @param line from 1
     * @param code of the finding that a line is not written as it should be
     */
    public static Words ofLine(SourceFile file, int line, String code) {
        return new Words(places(file, line).stream().map(Word::of).toList(), code);
    }

    /**
     * The words of a world with the values of its parameters.
     *
     * @param line from 1
     */
    static Words ofLine(SourceFile file, int line, Parameters parameters) throws Unreadable {
        List<Word> words = new ArrayList<>();
        for (Span place : places(file, line)) {
            words.add(parameters.read(place));
        }
        return new Words(words, SYNTAX);
    }

    private static List<Span> places(SourceFile file, int line) {
        int start = file.lineStart(line);
        List<Span> places = new ArrayList<>();
        Matcher matcher = WORD.matcher(file.line(line));
        while (matcher.find()) {
            if (matcher.group().charAt(0) != '#') {
                places.add(file.span(start + matcher.start(), start + matcher.end()));
            }
        }
        return places;
    }

    public boolean isEmpty() {
        return words.isEmpty();
    }

    /** The first word; it stays to be read. */
    public Word first() {
        return words.get(0);
    }

    /** Whether the second word of the line is this one. */
    public boolean isSecond(String word) {
        return words.size() > 1 && words.get(1).text().equals(word);
    }

    public boolean hasNext() {
        return position < words.size();
    }

    /** From the first word to the last. */
    public Span whole() {
        return words.get(0).place().to(words.get(words.size() - 1).place());
    }

    public Word next(String expected) throws Unreadable {
        return next(expected, List.of());
    }

    /**
     * @param choices words of which one may be the next; others may be, too
     */
    public Word next(String expected, List<String> choices) throws Unreadable {
        if (!hasNext()) {
            Span last = words.get(words.size() - 1).place();
            Span end = last.file().span(last.end(), last.end());
            throw new Unreadable(
                    Diagnostic.error(code, end, "here should follow " + expected), choices);
        }
        return words.get(position++);
    }

    /** From the next word to the last one, which is then read. */
    public Span rest(String expected) throws Unreadable {
        Span start = next(expected).place();
        position = words.size();
        return start.to(words.get(words.size() - 1).place());
    }

    /** The word that was read last is the next one again. */
    public void back() {
        position--;
    }

    /** A word with all that follows it in brackets: {@code p.Rover(3, "left")} is one. */
    Word call(String expected) throws Unreadable {
        Word call = next(expected);
        while (BRACKETS.matcher(call.text()).matches()) {
            call = call.and(next("')'"));
        }
        return call;
    }

    /** Reads the word, if it is the next one. */
    public boolean take(String word) {
        boolean there = hasNext() && words.get(position).text().equals(word);
        position += there ? 1 : 0;
        return there;
    }

    public void expect(String word) throws Unreadable {
        Word next = next("'" + word + "'", List.of(word));
        if (!next.text().equals(word)) {
            throw wrong(next, "'" + next.text() + "' stands where '" + word + "' should");
        }
    }

    /** A name as a brick can have: a letter, then letters, digits, - and _; up to 16. */
    Word name(String meaning) throws Unreadable {
        Word word = next(meaning);
        if (!NAME.matcher(word.text()).matches()) {
            throw isNot(word, meaning + ": a letter, then letters, digits, - and _, up to 16");
        }
        return word;
    }

    /** The name of a parameter: a letter, then letters, digits and _. */
    public Span parameter(String meaning) throws Unreadable {
        Word word = next(meaning);
        if (!PARAMETER.matcher(word.text()).matches()) {
            throw isNot(word, meaning + ": a letter, then letters, digits and _");
        }
        return word.place();
    }

    public double number(String meaning, double low, double high) throws Unreadable {
        String expected = "%s, %s to %s".formatted(meaning, shown(low), shown(high));
        Word word = next(expected);
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

    public int count(String meaning, int low, int high) throws Unreadable {
        double number = number(meaning, low, high);
        if (number != Math.rint(number)) {
            throw isNot(words.get(position - 1), meaning + ": it has to be whole");
        }
        return (int) number;
    }

    /** A place on the floor, or a way from one to another. */
    Point point() throws Unreadable {
        return new Point(number("x in mm", -FAR, FAR), number("y in mm", -FAR, FAR));
    }

    /** One of some words. */
    public Word choice(String meaning, List<String> allowed) throws Unreadable {
        String expected = meaning + ": " + String.join(", ", allowed);
        Word word = next(expected, allowed);
        if (!allowed.contains(word.text())) {
            throw isNot(word, expected);
        }
        return word;
    }

    public void end() throws Unreadable {
        if (hasNext()) {
            Word word = words.get(position);
            throw wrong(word, "'" + word.text() + "' is one word too many");
        }
    }

    private Unreadable isNot(Word word, String expected) {
        return wrong(word, "'" + word.text() + "' is not " + expected);
    }

    /** Something about a word that its reader has found. */
    public Unreadable wrong(Word word, String message) {
        return new Unreadable(word.error(code, message));
    }

    /** Something about this line that its reader has found. */
    public Unreadable wrong(Span place, String message) {
        return new Unreadable(Diagnostic.error(code, place, message));
    }

    static Unreadable broken(Word word, String message) {
        return new Unreadable(word.error(SYNTAX, message));
    }

    static Unreadable broken(Span place, String message) {
        return new Unreadable(Diagnostic.error(SYNTAX, place, message));
    }

    /** Gives up reading a line; the parser goes on with the next one. */
    public static final class Unreadable extends Exception {
        private static final long serialVersionUID = 1L;

        private final transient Diagnostic finding;
        private final transient List<String> choices;

        public Unreadable(Diagnostic finding) {
            this(finding, List.of());
        }

        private Unreadable(Diagnostic finding, List<String> choices) {
            super(finding.message());
            this.finding = finding;
            this.choices = List.copyOf(choices);
        }

        /** The words of which one is missing at the end of the line. */
        public List<String> choices() {
            return choices;
        }

        public Diagnostic finding() {
            return finding;
        }
    }
}
