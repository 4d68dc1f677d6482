package arcomat.guest;

import arcomat.check.law.Check.Findings;
import arcomat.source.Diagnostic;
import arcomat.source.Diagnostic.Related;
import arcomat.source.Fix;
import arcomat.source.Severity;
import arcomat.source.Span;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * What a behaviour in a guest's language means: the elements of an automaton, as they would stand
 * between its braces, each piece with the place that it comes from. Findings, traces and pictures
 * point there. Of a file in a guest's language, it is the text of the component that it stands for.
 */
public final class Meaning {
    private final List<Piece> pieces = new ArrayList<>();
    private final List<Problem> problems = new ArrayList<>();
    private final Map<String, String> codes = new LinkedHashMap<>();
    private final List<Span> names = new ArrayList<>();
    private boolean stands;
    private Optional<Span> element = Optional.empty();
    private int rank;
    private int turn;
    private List<Name> within = List.of();

    /**
     * A piece of Arcomat's text, and what it stands for.
     *
     * @param element that it is a part of; empty where pieces stand for themselves
     * @param rank of a transition that begins in it
     * @param turn of a transition that begins in it
     * @param within names of what a state stands in that begins in it, from the outermost on
     */
    public record Piece(
            Span place,
            String text,
            Optional<Span> element,
            int rank,
            int turn,
            List<Name> within) {
        public Piece {
            within = List.copyOf(within);
        }
    }

    /**
     * Something that is wrong with what somebody wrote.
     *
     * @param code of the language's own; empty where it has none for it
     * @param related other places that have to do with it, each with a note
     * @param fix what mends it
     * @param gap the part of the text without which the rest can be read
     */
    public record Problem(
            Optional<String> code,
            Span place,
            String message,
            List<Related> related,
            Optional<Fix> fix,
            Optional<Span> gap) {
        public Problem {
            related = List.copyOf(related);
        }
    }

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
     * The transitions to come have their turn: one is taken only where nothing is there that one
     * out of the same state with a smaller number asks for in its input block and its guard. Unlike
     * a {@link #rank}, it does not matter whether that one could be taken, which it could not where
     * it sends what is not there. So the first row of a table decides that fits.
     *
     * @param number from 0 on; at first it is 0
     */
    public Meaning turn(int number) {
        turn = number;
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
        pieces.add(new Piece(place, all, element, rank, turn, within));
        return this;
    }

    /**
     * Says what is wrong; the behaviour is not used then, unless {@link #stands} has been said.
     *
     * @param message as those of the tool: it names the thing, says what to do, and begins with a
     *     small letter
     */
    public Meaning problem(Span place, String message) {
        return problem(Optional.empty(), place, message);
    }

    /**
     * The same, with a code of {@link BehaviourLanguage#codes}, for which there is a page.
     *
     * @param message as above
     */
    public Meaning problem(String code, Span place, String message) {
        return problem(Optional.of(code), place, message);
    }

    private Meaning problem(Optional<String> code, Span place, String message) {
        problems.add(
                new Problem(code, place, message, List.of(), Optional.empty(), Optional.empty()));
        return this;
    }

    /**
     * Says that nothing has the name that stands at a place. If one of the candidates is close, the
     * message asks for it, and a repair puts it there.
     *
     * @param message as above, without what to do
     * @param otherwise what to do where none is close
     */
    public Meaning unknown(
            String code,
            Span place,
            String message,
            String name,
            Collection<String> candidates,
            String otherwise) {
        Diagnostic found =
                new Findings(code, Severity.ERROR)
                        .reportUnknown(place, message, name, candidates, otherwise)
                        .diagnostics()
                        .get(0);
        problems.add(
                new Problem(
                        Optional.of(code),
                        place,
                        found.message(),
                        found.related(),
                        found.fix(),
                        Optional.empty()));
        return this;
    }

    /** Adds another place to the problem that was said last. */
    public Meaning related(Span place, String note) {
        Problem last = last();
        List<Related> related = new ArrayList<>(last.related());
        related.add(new Related(place, note));
        return insteadOfLast(
                new Problem(
                        last.code(),
                        last.place(),
                        last.message(),
                        related,
                        last.fix(),
                        last.gap()));
    }

    /** Adds what mends the problem that was said last: an edit of the language's own text. */
    public Meaning fix(Fix fix) {
        Problem last = last();
        return insteadOfLast(
                new Problem(
                        last.code(),
                        last.place(),
                        last.message(),
                        last.related(),
                        Optional.of(fix),
                        last.gap()));
    }

    /**
     * The problem that was said last is that of a part of the text, as of one row or one
     * transition, without which the rest can be read. Where that is so of all problems, the
     * language is asked once more, with {@link BehaviourLanguage.Written#text blanks} in the place
     * of such parts; what it says then is the meaning of the rest. Of use while the text alone is
     * looked at: who has looked around says {@link #stands}.
     *
     * @param part of the body
     */
    public Meaning gap(Span part) {
        Problem last = last();
        return insteadOfLast(
                new Problem(
                        last.code(),
                        last.place(),
                        last.message(),
                        last.related(),
                        last.fix(),
                        Optional.of(part)));
    }

    private Problem last() {
        if (problems.isEmpty()) {
            throw new IllegalStateException("no problem was said that this could belong to");
        }
        return problems.get(problems.size() - 1);
    }

    private Meaning insteadOfLast(Problem other) {
        problems.set(problems.size() - 1, other);
        return this;
    }

    /**
     * What is written here is the meaning of all that is right, whatever problems there are: what
     * laws find in it is told besides. Only a {@link SituatedLanguage} may say so that has looked
     * around.
     */
    public Meaning stands() {
        stands = true;
        return this;
    }

    /**
     * What a law of the tool finds in this behaviour is told with another code.
     *
     * @param law its code
     * @param own one of {@link BehaviourLanguage#codes}
     */
    public Meaning tell(String law, String own) {
        codes.put(law, own);
        return this;
    }

    /**
     * A port, a variable or a parameter is named here, besides where pieces take names over: an
     * editor finds and renames it.
     */
    public Meaning names(Span place) {
        names.add(place);
        return this;
    }

    public List<Piece> pieces() {
        return List.copyOf(pieces);
    }

    public List<Problem> problems() {
        return List.copyOf(problems);
    }

    /** Whether what is written is looked at in spite of problems. */
    public boolean isStanding() {
        return stands;
    }

    /** With which codes findings are told, by the codes of the laws. */
    public Map<String, String> codes() {
        return Collections.unmodifiableMap(codes);
    }

    /** Places that name something, besides what pieces take over. */
    public List<Span> named() {
        return List.copyOf(names);
    }
}
