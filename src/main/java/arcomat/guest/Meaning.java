package arcomat.guest;

import arcomat.source.Span;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * What a behaviour in a guest's language means: the elements of an automaton, as they would stand
 * between its braces, each piece with the place that it comes from. Findings, traces and pictures
 * point there. Of a file in a guest's language, it is the text of the component that it stands for.
 */
public final class Meaning {
    private final List<Piece> pieces = new ArrayList<>();
    private final List<Problem> problems = new ArrayList<>();
    private Optional<Span> element = Optional.empty();
    private int rank;
    private List<Name> within = List.of();

    /**
     * A piece of Arcomat's text, and what it stands for.
     *
     * @param element that it is a part of; empty where pieces stand for themselves
     * @param rank of a transition that begins in it
     * @param within names of what a state stands in that begins in it, from the outermost on
     */
    public record Piece(
            Span place, String text, Optional<Span> element, int rank, List<Name> within) {
        public Piece {
            within = List.copyOf(within);
        }
    }

    /**
     * Something that is wrong with what somebody wrote.
     *
     * @param code of the language's own; empty where it has none for it
     */
    public record Problem(Optional<String> code, Span place, String message) {}

    /**
     * Begins an element: what reaches over several of the pieces to come has this place, and not
     * all that lies between theirs. So an automaton's transition may be made of what stands far
     * apart.
     */
    public Meaning element(Span place) {
        element = Optional.of(place);
        return this;
    }

    /**
     * The transitions to come are taken only where none out of the same state with a smaller number
     * is enabled. At first the number is 0; among transitions of one number it stays open which is
     * taken.
     *
     * @param number from 0 on
     */
    public Meaning rank(int number) {
        rank = number;
        return this;
    }

    /**
     * The states to come stand in others, which are drawn around them.
     *
     * @param names of those, from the outermost on; none at first
     */
    public Meaning within(List<Name> names) {
        within = List.copyOf(names);
        return this;
    }

    /**
     * Adds elements of the automaton, or a part of one.
     *
     * @param place what they stand for, in the file that is translated
     * @param text a format for the values, if there are some
     */
    public Meaning write(Span place, String text, Object... values) {
        String all = values.length == 0 ? text : String.format(Locale.ROOT, text, values);
        pieces.add(new Piece(place, all, element, rank, within));
        return this;
    }

    /**
     * Says what is wrong; the behaviour is not used then.
     *
     * @param message as those of the tool: it names the thing, says what to do, and begins with a
     *     small letter
     */
    public Meaning problem(Span place, String message) {
        problems.add(new Problem(Optional.empty(), place, message));
        return this;
    }

    /**
     * The same, with a code of {@link BehaviourLanguage#codes}, for which there is a page.
     *
     * @param message as above
     */
    public Meaning problem(String code, Span place, String message) {
        problems.add(new Problem(Optional.of(code), place, message));
        return this;
    }

    public List<Piece> pieces() {
        return List.copyOf(pieces);
    }

    public List<Problem> problems() {
        return List.copyOf(problems);
    }
}
