package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.source.Span;
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
final class Suppressions {
    static final String STEREOTYPE = "suppress";

    private final Map<String, List<Suppression>> byFile = new HashMap<>();

    private record Suppression(Span element, String code, String reason) {}

    /** The parts of a value that is well-formed. */
    record Value(String code, String reason) {

        static Optional<Value> parse(String text) {
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

    void add(List<Stereotype> stereotypes, Node owner) {
        for (Stereotype stereotype : stereotypes) {
            if (stereotype.name().text().equals(STEREOTYPE)) {
                stereotype
                        .value()
                        .flatMap(value -> Value.parse(value.text()))
                        .ifPresent(value -> add(value, owner.span()));
            }
        }
    }

    private void add(Value value, Span element) {
        byFile.computeIfAbsent(element.file().path(), path -> new ArrayList<>())
                .add(new Suppression(element, value.code(), value.reason()));
    }

    void addAll(Suppressions other) {
        other.byFile.forEach(
                (path, more) ->
                        byFile.computeIfAbsent(path, each -> new ArrayList<>()).addAll(more));
    }

    /** Why a finding is meant, if an element around it says so. */
    Optional<String> reason(Diagnostic finding) {
        for (Suppression suppression :
                byFile.getOrDefault(finding.span().file().path(), List.of())) {
            if (suppression.code().equals(finding.code())
                    && covers(suppression.element(), finding.span())) {
                return Optional.of(suppression.reason());
            }
        }
        return Optional.empty();
    }

    private static boolean covers(Span element, Span finding) {
        return element.start() <= finding.start() && finding.end() <= element.end();
    }
}
