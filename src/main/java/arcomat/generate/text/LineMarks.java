package arcomat.generate.text;

import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The lines of a file that are reached exactly where its automaton has done something. Templates
 * mark them while they write, and no file keeps the marks: whoever asks for lines or not, the file
 * is the same.
 *
 * @param transitions lines, from 1, by the index of the transition that has been taken there
 * @param initials lines, from 1, by the index of the beginning that is over there
 */
public record LineMarks(Map<Integer, Integer> transitions, Map<Integer, Integer> initials) {
    public static final LineMarks NONE = new LineMarks(Map.of(), Map.of());

    /** No text of a model comes into a file with a control character in it. */
    private static final char EDGE = '\u0001';

    private static final String TRANSITION = "t";
    private static final String INITIAL = "i";
    private static final Pattern MARK =
            Pattern.compile(EDGE + "([" + TRANSITION + INITIAL + "])(\\d+)" + EDGE);

    public LineMarks {
        transitions = Map.copyOf(transitions);
        initials = Map.copyOf(initials);
    }

    /** A text with its marks taken out. */
    public record Read(String text, LineMarks marks) {}

    /** For the line on which a transition has been taken. */
    public static String transition(int index) {
        return EDGE + TRANSITION + index + EDGE;
    }

    /** For the line on which a beginning is over. */
    public static String initial(int index) {
        return EDGE + INITIAL + index + EDGE;
    }

    public static Read read(String text) {
        if (text.indexOf(EDGE) < 0) {
            return new Read(text, NONE);
        }
        Map<Integer, Integer> transitions = new TreeMap<>();
        Map<Integer, Integer> initials = new TreeMap<>();
        StringBuilder plain = new StringBuilder();
        Matcher mark = MARK.matcher(text);
        int line = 1;
        int from = 0;
        while (mark.find()) {
            String before = text.substring(from, mark.start());
            line += (int) before.chars().filter(c -> c == '\n').count();
            plain.append(before);
            boolean taken = mark.group(1).equals(TRANSITION);
            (taken ? transitions : initials).put(Integer.valueOf(mark.group(2)), line);
            from = mark.end();
        }
        plain.append(text, from, text.length());
        return new Read(plain.toString(), new LineMarks(transitions, initials));
    }
}
