package arcomat.world;

import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;

/**
 * A word of a world, or of a text that is read like one.
 *
 * @param text what it says: parameters are replaced by their values
 * @param place where it is written
 * @param values of the parameters that stand in it
 */
public record Word(String text, Span place, List<Given> values) {
    public Word {
        values = List.copyOf(values);
    }

    /** A word as it is written. */
    static Word of(Span place) {
        return new Word(place.text(), place, List.of());
    }

    /** A parameter with its value in this run. */
    public record Given(WorldParameter parameter, String value) {}

    /** This one and the next one of the line, with a blank between them. */
    Word and(Word next) {
        List<Given> all = new ArrayList<>(values);
        all.addAll(next.values);
        return new Word(text + " " + next.text, place.to(next.place), all);
    }

    /** The same word; what stands in another one, by which it is told, is said beside it. */
    Word toldWith(Word other) {
        List<Given> all = new ArrayList<>(values);
        all.addAll(other.values);
        return new Word(text, place, all);
    }

    /** A finding about this word, which says where its text comes from if that is elsewhere. */
    Diagnostic error(String code, String message) {
        Diagnostic finding = Diagnostic.error(code, place, message);
        for (Given given : new LinkedHashSet<>(values)) {
            finding =
                    finding.withRelated(
                            given.parameter().place(),
                            "'$%s' is '%s'".formatted(given.parameter().name(), given.value()));
        }
        return finding;
    }
}
