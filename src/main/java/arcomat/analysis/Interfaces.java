package arcomat.analysis;

import arcomat.analysis.Verdict.Sentence;
import arcomat.model.Component;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Whether two components can be compared at all: the left one has every port of the right one, of
 * the same type, and atomic components send with the same delay.
 */
final class Interfaces {
    private Interfaces() {}

    /** The verdict where they cannot; else empty. */
    static Optional<Verdict> compare(Promise left, Promise right) {
        List<Sentence> problems = new ArrayList<>();
        Component own = left.component();
        Component other = right.component();
        if (own.profile() != other.profile()) {
            problems.add(
                    new Sentence(
                            "one of them handles events, the other one works slice by slice",
                            Optional.of(own.span())));
        }
        for (Port port : other.ports()) {
            problem(own, port, other).ifPresent(problems::add);
        }
        if (!problems.isEmpty()) {
            return Optional.of(Verdict.fails("interface", problems));
        }
        boolean atomic = !left.isComposition() && !right.isComposition();
        for (Port port : other.outputs()) {
            Port mine = own.port(port.name()).orElseThrow();
            if (atomic && mine.delay() != port.delay()) {
                problems.add(
                        new Sentence(
                                "'%s' has delay %d in %s and delay %d in %s"
                                        .formatted(
                                                port.name(),
                                                mine.delay(),
                                                own.qualifiedName(),
                                                port.delay(),
                                                other.qualifiedName()),
                                Optional.of(mine.span())));
            }
        }
        return problems.isEmpty()
                ? Optional.empty()
                : Optional.of(Verdict.fails("delay", problems));
    }

    private static Optional<Sentence> problem(Component own, Port port, Component other) {
        String kind = port.isInput() ? "input" : "output";
        Optional<Port> found =
                own.port(port.name()).filter(each -> each.isInput() == port.isInput());
        if (found.isEmpty()) {
            return Optional.of(
                    new Sentence(
                            "%s has no %s port '%s', which %s has"
                                    .formatted(
                                            own.qualifiedName(),
                                            kind,
                                            port.name(),
                                            other.qualifiedName()),
                            Optional.of(port.span())));
        }
        if (!found.get().type().equals(port.type())) {
            return Optional.of(
                    new Sentence(
                            "'%s' carries %s in %s and %s in %s"
                                    .formatted(
                                            port.name(),
                                            found.get().type().name(),
                                            own.qualifiedName(),
                                            port.type().name(),
                                            other.qualifiedName()),
                            Optional.of(found.get().span())));
        }
        if (found.get().latched() != port.latched()) {
            return Optional.of(
                    new Sentence(
                            "'%s' keeps its value in one of them, and is an event in the other"
                                    .formatted(port.name()),
                            Optional.of(found.get().span())));
        }
        if (port.isInput() && found.get().total() && !port.total()) {
            return Optional.of(
                    new Sentence(
                            "'%s' may be silent for %s, but %s needs a message in every slice"
                                    .formatted(
                                            port.name(),
                                            other.qualifiedName(),
                                            own.qualifiedName()),
                            Optional.of(found.get().span())));
        }
        return Optional.empty();
    }
}
