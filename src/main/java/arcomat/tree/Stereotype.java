package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/**
 * One entry of a {@code <<..>>} list.
 *
 * @param value the value without quotes; empty where only the name stands
 */
public record Stereotype(Span span, Name name, Optional<Name> value) implements Node {
    /** The first entry with a name. */
    public static Optional<Stereotype> find(List<Stereotype> stereotypes, String name) {
        for (Stereotype s : stereotypes) {
            if (s.name().text().equals(name)) {
                return Optional.of(s);
            }
        }
        return Optional.empty();
    }
}
