package arcomat.check.law;

import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.tree.Name;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What {@code <<suppress = "ARC0104: reason">>} declares to be meant: findings with that code
 * inside the element that carries it.
 */
public final class Suppressions {
    public static final String STEREOTYPE = "suppress";

    private final Map<String, List<Suppression>> byFile = new HashMap<>();

    /**
     * One declaration.
     *
     * @param element that carries it
     * @param place of the declaration itself
     */
    public record Suppression(Span element, Span place, String code, String reason) {

        private boolean covers(Diagnostic finding) {
            return code.equals(finding.code()) && element.isAround(finding.span());
        }

        /** As {@link Span}'s own: Java would put the record's together when it is first asked. */
        @Override
        public int hashCode() {
            return place.hashCode();
        }
    }

    /** The parts of a value that is well-formed. */
    public record Value(String code, String reason) {

        public static Optional<Value> parse(String text) {
            int colon = text.indexOf(':');
            if (colon < 0) {
                return Optional.empty();
            }
            String reason = text.substring(colon + 1).strip();
            return reason.isEmpty()
                    ? Optional.empty()
                    : Optional.of(new Value(text.substring(0, colon).strip(), reason));
        }
    }

    public void add(List<Stereotype> stereotypes, Node owner) {
        for (Stereotype stereotype : stereotypes) {
            if (stereotype.name().text().equals(STEREOTYPE)) {
                stereotype
                        .value()
                        .map(Name::text)
                        .flatMap(Value::parse)
                        .ifPresent(value -> add(value, stereotype.span(), owner.span()));
            }
        }
    }

    private void add(Value value, Span place, Span element) {
        byFile.computeIfAbsent(element.file().path(), path -> new ArrayList<>())
                .add(new Suppression(element, place, value.code(), value.reason()));
    }

    public void addAll(Suppressions other) {
        other.byFile.forEach(
                (path, more) ->
                        byFile.computeIfAbsent(path, each -> new ArrayList<>()).addAll(more));
    }

    public List<Suppression> all() {
        return byFile.values().stream().flatMap(List::stream).toList();
    }

    /** Those that declare a finding to be meant, the reason of the first counts. */
    public List<Suppression> covering(Diagnostic finding) {
        return byFile.getOrDefault(finding.span().file().path(), List.of()).stream()
                .filter(suppression -> suppression.covers(finding))
                .toList();
    }
}
