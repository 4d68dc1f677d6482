package arcomat.sim.script;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A word of a script and where it stands.
 *
 * @param column from 1
 */
record Word(String text, int line, int column) {
    private static final Pattern WORD = Pattern.compile("\\S+");
    private static final char COMMENT = '#';

    /** The words of a line before its comment. */
    static List<Word> split(String line, int number) {
        int comment = line.indexOf(COMMENT);
        Matcher matcher = WORD.matcher(comment < 0 ? line : line.substring(0, comment));
        List<Word> words = new ArrayList<>();
        while (matcher.find()) {
            words.add(new Word(matcher.group(), number, matcher.start() + 1));
        }
        return words;
    }

    /** The empty word right after this one: where something is missing. */
    Word after() {
        return new Word("", line, column + text.length());
    }

    BrokenLine broken(String message) {
        return new BrokenLine(new ScriptError(line, column, Math.max(1, text.length()), message));
    }
}
