package arcomat.analysis.map;

import arcomat.analysis.automaton.Functionality;
import arcomat.analysis.map.Bridge.Sides;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.Promise;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * How the ports of a concrete component stand for those of an abstract one. A port of a map stands
 * for one of a component if it has its name; a component cannot have two ports of a name, so where
 * both sides have one, the name of its component may be added, {@code speedOfWheels}. Ports that a
 * map does not mention stand for their namesakes.
 *
 * @param title of the component that says it
 * @param inputs reads what the concrete component reads, and sends what the abstract one reads
 * @param outputs reads what the concrete component sends, and perhaps what it reads, and sends what
 *     the abstract one sends
 */
public record InterfaceMap(String title, Optional<Promise> inputs, Optional<Promise> outputs) {

    /**
     * Whether what the concrete component does is, seen through the map, what the abstract one
     * allows: for each run of the first with inputs i and outputs o, and all that the map may make
     * of o, the second allows that for what the map makes of i.
     *
     * <p>What the map makes of inputs has to be one thing. Were there a choice, it would be made on
     * the side of the abstract component, which is to allow all of them and not one.
     */
    public Verdict check(Promise concrete, Promise wanted, Budget budget) {
        if (handlesEvents(concrete, wanted)) {
            return Verdict.unknown(
                    "a map says what stands for what slice by slice, and there are events");
        }
        Optional<String> choice = inputs.flatMap(each -> Functionality.obstacle(each, budget));
        if (choice.isPresent()) {
            return Verdict.unknown(
                    "what %s makes of inputs has to be certain: %s".formatted(title, choice.get()));
        }
        return Refinement.all(
                wanted.each().stream().map(each -> compare(concrete, each, budget)).toList());
    }

    private boolean handlesEvents(Promise concrete, Promise wanted) {
        return Stream.concat(Stream.of(concrete, wanted), halves())
                .anyMatch(each -> each.component().profile() == Component.Profile.EVENT_DRIVEN);
    }

    private Stream<Promise> halves() {
        return Stream.concat(inputs.stream(), outputs.stream());
    }

    private Verdict compare(Promise concrete, Promise wanted, Budget budget) {
        Sides sides = Bridge.between(concrete, wanted, this);
        if (!sides.problems().isEmpty()) {
            return Verdict.fails("interface", sides.problems());
        }
        Verdict verdict = Refinement.check(sides.left(), sides.right(), budget);
        return verdict.answer() == Answer.HOLDS
                ? new MapVacuity(concrete, wanted, this, sides.right(), budget).noted(verdict)
                : verdict;
    }

    /** The two sides as they are compared, for a picture; none where the map does not fit. */
    public List<Promise> sides(Promise concrete, Promise wanted) {
        Sides sides = Bridge.between(concrete, wanted, this);
        return sides.problems().isEmpty() ? List.of(sides.left(), sides.right()) : List.of();
    }

    /** {@code speedOfWheels}. */
    static String longName(Port port, Component owner) {
        return port.name() + "Of" + simpleName(owner);
    }

    /** {@code Wheels} of {@code Cart.Wheels<Integer>}. */
    static String simpleName(Component component) {
        String name = component.name().replaceFirst("<.*", "");
        return name.substring(name.lastIndexOf('.') + 1);
    }
}
