package arcomat.guest;

import java.util.ArrayList;
import java.util.List;

/**
 * A layout for languages of statements and blocks: lines stay what they are, each is moved to where
 * the braces around it say, four blanks for each. A line that goes on with the one above is moved
 * eight further. Comments of several lines are left alone but for the first.
 */
public final class Indentation {
    private static final int STEP = 4;

    private final List<String> lines = new ArrayList<>();
    private int depth;
    private boolean inComment;
    private boolean goesOn;

    private Indentation() {}

    /** The text, set anew; where it holds nothing but blanks, nothing. */
    public static String of(String text) {
        Indentation indentation = new Indentation();
        text.lines().forEach(indentation::add);
        List<String> lines = indentation.lines;
        while (!lines.isEmpty() && lines.get(lines.size() - 1).isEmpty()) {
            lines.remove(lines.size() - 1);
        }
        return String.join("\n", lines);
    }

    private void add(String line) {
        String stripped = line.strip();
        boolean within = inComment;
        int level = depth - (stripped.startsWith("}") ? 1 : 0) + (goesOn ? 2 : 0);
        if (within || !stripped.isEmpty()) {
            lines.add(within ? line : " ".repeat(STEP * Math.max(0, level)) + stripped);
            read(stripped);
        } else if (!lines.isEmpty() && !lines.get(lines.size() - 1).isEmpty()) {
            lines.add("");
        }
    }

    /** Takes down what a line leaves open. */
    private void read(String line) {
        for (int i = 0; i < line.length(); ) {
            i = inComment ? endOfComment(line, i) : read(line, i);
        }
    }

    /** Returns where to go on. */
    private int read(String line, int at) {
        char sign = line.charAt(at);
        if (line.startsWith("//", at)) {
            return line.length();
        }
        if (line.startsWith("/*", at)) {
            inComment = true;
            return at + 2;
        }
        depth += sign == '{' ? 1 : sign == '}' ? -1 : 0;
        if (!Character.isWhitespace(sign)) {
            goesOn = ";{}".indexOf(sign) < 0;
        }
        return sign == '"' || sign == '\'' ? endOfLiteral(line, at) : at + 1;
    }

    private int endOfComment(String line, int from) {
        int end = line.indexOf("*/", from);
        inComment = end < 0;
        return end < 0 ? line.length() : end + 2;
    }

    private static int endOfLiteral(String line, int quote) {
        for (int i = quote + 1; i < line.length(); i++) {
            if (line.charAt(i) == '\\') {
                i++;
            } else if (line.charAt(i) == line.charAt(quote)) {
                return i + 1;
            }
        }
        return line.length();
    }
}
