package arcomat.syntax.runtime;

import org.antlr.v4.runtime.CharStream;
import org.antlr.v4.runtime.misc.Interval;

/**
 * A text for the lexer, unit by unit. ANTLR's own streams count code points, so behind a character
 * outside the basic plane their positions would not be those of {@code arcomat.source}.
 */
final class Characters implements CharStream {
    private final String name;
    private final String text;
    private int next;

    Characters(String name, String text) {
        this.name = name;
        this.text = text;
    }

    @Override
    public int LA(int offset) {
        int index = next + (offset > 0 ? offset - 1 : offset);
        return index >= 0 && index < text.length() ? text.charAt(index) : EOF;
    }

    @Override
    public void consume() {
        if (next >= text.length()) {
            throw new IllegalStateException("consume at the end of the text");
        }
        next++;
    }

    @Override
    public String getText(Interval interval) {
        return text.substring(interval.a, Math.min(interval.b + 1, text.length()));
    }

    @Override
    public int index() {
        return next;
    }

    @Override
    public void seek(int index) {
        next = index;
    }

    @Override
    public int size() {
        return text.length();
    }

    @Override
    public int mark() {
        return -1;
    }

    @Override
    public void release(int marker) {}

    @Override
    public String getSourceName() {
        return name;
    }
}
