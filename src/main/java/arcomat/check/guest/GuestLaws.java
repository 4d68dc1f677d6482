package arcomat.check.guest;

import arcomat.check.law.Law;
import arcomat.symbols.signatures.BehaviourReader;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The laws of one guest.
 *
 * @param guest its name
 * @param identity tells it from every other guest, and from itself with other content
 * @param others codes of what it finds besides, in texts of its languages and by its analyses
 * @param reader of behaviours in its languages, where names have to be known for that
 * @param pages what it has to say about a code, in Markdown
 */
public record GuestLaws(
        String guest,
        String identity,
        List<Law> laws,
        List<String> others,
        BehaviourReader reader,
        Function<String, Optional<String>> pages) {
    public GuestLaws {
        laws = List.copyOf(laws);
        others = List.copyOf(others);
    }

    /** Of all that it may find. */
    public List<String> codes() {
        return Stream.concat(laws.stream().map(Law::code), others.stream()).toList();
    }
}
