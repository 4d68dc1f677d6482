package arcomat.guest;

import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What a behaviour in a guest's language means: the elements of an automaton, as they would stand
 * between its braces, each piece with the place that it comes from. Findings, traces and pictures
 * point there.
 */
public final class Meaning {
    private final List<Piece> pieces = new ArrayList<>();
    private final List<Problem> problems = new ArrayList<>();

    /** A piece of Arcomat's text, and what it stands for. */
    public record Piece(Span place, String text) {}

    /** Something that is wrong with what somebody wrote. */
    public record Problem(Span place, String message) {}

    /**
     * Adds elements of the automaton, or a part of one.
     *
     * @param place what they stand for, in the file that is translated
     * @param text a format for the values, if there are some
     */
    public Meaning write(Span place, String text, Object... values) {
        String all = values.length == 0 ? text : String.format(Locale.ROOT, text, values);
        pieces.add(new Piece(place, all));
        return this;
    }

    /**
     * Says what is wrong; the behaviour is not used then.
     *
     * @param message as those of the tool: it names the thing, says what to do, and begins with a
     *     small letter
     */
    public Meaning problem(Span place, String message) {
        problems.add(new Problem(place, message));
        return this;
    }

    public List<Piece> pieces() {
        return List.copyOf(pieces);
    }

    public List<Problem> problems() {
        return List.copyOf(problems);
    }
}
