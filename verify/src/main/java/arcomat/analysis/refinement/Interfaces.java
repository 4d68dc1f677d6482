package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.semantics.Promise;
import arcomat.semantics.network.Feedthrough;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Whether two components can be compared at all: the left one has every port of the right one, of
 * the same type, and depends on inputs in the same slice only where the right one may.
 */
public final class Interfaces {
    private Interfaces() {}

    /** The verdict where they cannot; else empty. */
    public static Optional<Verdict> compare(Promise left, Promise right) {
        List<Sentence> problems = new ArrayList<>();
        Component own = left.component();
        if (own.profile() != right.component().profile()) {
            problems.add(
                    Sentence.at(
                            own.span(),
                            "one of them handles events, the other one works slice by slice"));
        }
        Map<String, Port> mine = new HashMap<>();
        left.drivenPorts().forEach(port -> mine.put(port.name(), port));
        for (Port port : right.drivenPorts()) {
            Optional<Port> found = Optional.ofNullable(mine.get(port.name()));
            problem(left, found, port, right).ifPresent(problems::add);
        }
        if (!problems.isEmpty()) {
            return Optional.of(Verdict.fails("interface", problems));
        }
        feedthrough(left, right).forEach(problems::add);
        return problems.isEmpty()
                ? Optional.empty()
                : Optional.of(Verdict.fails("delay", problems));
    }

    /**
     * An output may depend on an input in the same slice only where it may on the right side, too:
     * else there is a feedback into which the right side fits, and the left one closes a circle.
     */
    private static List<Sentence> feedthrough(Promise left, Promise right) {
        if (left.component().profile() == Component.Profile.EVENT_DRIVEN) {
            return List.of();
        }
        Map<String, BitSet> mine = Feedthrough.of(left.component(), left.isComposition());
        Map<String, BitSet> theirs = Feedthrough.of(right.component(), right.isComposition());
        List<String> own = left.component().inputs().stream().map(Port::name).toList();
        List<Sentence> problems = new ArrayList<>();
        for (Port output : right.component().outputs()) {
            List<Port> inputs = right.component().inputs();
            for (int i = 0; i < inputs.size(); i++) {
                int position = own.indexOf(inputs.get(i).name());
                if (Objects.requireNonNull(mine.get(output.name())).get(position)
                        && !Objects.requireNonNull(theirs.get(output.name())).get(i)) {
                    problems.add(
                            Sentence.at(
                                    left.component().port(output.name()).get().span(),
                                    "'%s' of %s may depend on '%s' in the same slice, that of %s"
                                            + " does not: a feedback could become a circle",
                                    output.name(),
                                    left.title(),
                                    inputs.get(i).name(),
                                    right.title()));
                }
            }
        }
        return problems;
    }

    private static Optional<Sentence> problem(
            Promise left, Optional<Port> namesake, Port port, Promise right) {
        String name = port.name();
        if (namesake.isEmpty() || namesake.get().isInput() != port.isInput()) {
            String has = "%s has no %s port '%s', which %s has";
            return Optional.of(
                    Sentence.at(port.span(), has, left.title(), kind(port), name, right.title()));
        }
        Port own = namesake.get();
        Span place = own.span();
        if (!own.type().equals(port.type())) {
            String mine = words(own.type(), port.type());
            String theirs = words(port.type(), own.type());
            String carries = "'%s' carries %s in %s and %s in %s";
            return Optional.of(
                    Sentence.at(place, carries, name, mine, left.title(), theirs, right.title()));
        }
        if (own.latched() != port.latched()) {
            String keeps = "'%s' keeps its value in one of them, and is an event in the other";
            return Optional.of(Sentence.at(place, keeps, name));
        }
        if (port.isInput() && own.total() && !port.total()) {
            String needs = "'%s' may be silent for %s, but %s needs a message in every slice";
            return Optional.of(Sentence.at(place, needs, name, right.title(), left.title()));
        }
        return Optional.empty();
    }

    /** What belongs to a device is named by its path. */
    private static String kind(Port port) {
        boolean device = port.name().contains(".");
        return port.isInput() ? device ? "sensor" : "input" : device ? "actuator" : "output";
    }

    /** The name of a type; where another one has the same name, what it consists of, too. */
    private static String words(Type type, Type other) {
        return type.name().equals(other.name()) ? contents(type) : type.name();
    }

    private static String contents(Type type) {
        if (type instanceof Type.EnumType numbered) {
            return type.name() + " {" + String.join(", ", numbered.constants()) + "}";
        }
        if (type instanceof Type.ClassType object) {
            return type.name()
                    + object.attributes().stream()
                            .map(each -> contents(each.type()) + " " + each.name())
                            .collect(Collectors.joining("; ", " {", "}"));
        }
        return type.name();
    }
}
