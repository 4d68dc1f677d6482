package montiarc7;

import montiarc7.grammar.MontiArc7Parser.AutoElementContext;
import montiarc7.grammar.MontiArc7Parser.AutomatonElementContext;
import montiarc7.grammar.MontiArc7Parser.BlockContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ComputeElementContext;
import montiarc7.grammar.MontiArc7Parser.ConnectorElementContext;
import montiarc7.grammar.MontiArc7Parser.ElementContext;
import montiarc7.grammar.MontiArc7Parser.InitElementContext;
import montiarc7.grammar.MontiArc7Parser.InnerElementContext;
import montiarc7.grammar.MontiArc7Parser.InstanceElementContext;
import montiarc7.grammar.MontiArc7Parser.ModesElementContext;
import montiarc7.grammar.MontiArc7Parser.NameContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;
import montiarc7.source.Placed;
import montiarc7.source.Placed.Side;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** What the variants of one component say of time, each for itself. */
final class Variants {
    private final ComponentContext component;
    private final List<Placed> elements;
    private final List<Placed> behaviours;
    private final Lacks lacks;
    private final Optional<Boolean> byEvents;

    Variants(ComponentContext component, Lacks lacks) {
        this.component = component;
        this.elements = Placed.of(component.element());
        this.behaviours =
                elements.stream()
                        .filter(
                                each ->
                                        each.element() instanceof AutomatonElementContext
                                                || each.element() instanceof ComputeElementContext)
                        .toList();
        this.lacks = lacks;
        Set<Boolean> said = new HashSet<>();
        behaviours.forEach(each -> said.add(timing(each.sides(), lacks).isByEvents()));
        this.byEvents = said.size() == 1 ? Optional.of(said.iterator().next()) : Optional.empty();
    }

    List<Placed> elements() {
        return elements;
    }

    boolean behave() {
        return !behaviours.isEmpty();
    }

    /**
     * Whether nothing is known of it but its ports, which are in time with slices: somebody else
     * says what it does, and its outputs may depend on inputs of the same slice.
     */
    boolean isSynchronousInterface() {
        return behaviours.isEmpty()
                && elements.stream().noneMatch(each -> isStructure(each.element()))
                && timing(List.of(), lacks.unheard()).isSynchronous();
    }

    private static boolean isStructure(ElementContext element) {
        return element instanceof InstanceElementContext
                || element instanceof InnerElementContext
                || element instanceof ConnectorElementContext
                || element instanceof AutoElementContext
                || element instanceof ModesElementContext;
    }

    /** Whether steps are events, where all variants agree. */
    Optional<Boolean> byEvents() {
        return byEvents;
    }

    boolean isByEvents(List<Side> sides) {
        return timing(sides, lacks.unheard()).isByEvents();
    }

    private Timing timing(List<Side> sides, Lacks told) {
        return new Timing(
                component,
                elements.stream()
                        .filter(each -> each.goesWith(sides))
                        .map(Placed::element)
                        .toList(),
                told);
    }

    /** Whether a port sends one slice later; variants that have the port agree on that. */
    boolean isLate(NameContext port, List<Side> sides) {
        if (isSynchronousInterface()) {
            return timing(sides, lacks.unheard()).isDelayed(port.getText());
        }
        Set<Boolean> said = new HashSet<>();
        for (Placed each : behaviours) {
            if (each.goesWith(sides)) {
                List<Side> both = new ArrayList<>(sides);
                both.addAll(each.sides());
                Timing timing = timing(both, lacks.unheard());
                boolean late = timing.isDelayed(port.getText());
                said.add(late && !timing.isByEvents());
                if (late && timing.isByEvents()) {
                    lacks.note(
                            Lack.START,
                            port,
                            "events have no delay: '%s' is sent at once".formatted(port.getText()));
                }
            }
        }
        if (said.size() > 1) {
            lacks.missing(
                    Lack.VARIABILITY,
                    port,
                    "'%s' is delayed in some variants only; declare it in each of them"
                            .formatted(port.getText()));
        }
        return said.contains(true);
    }

    /**
     * Output ports that send before the first input, in what is there together: all of them by
     * events.
     */
    Set<String> late(Set<String> outputs, List<Side> sides) {
        Timing timing = timing(sides, lacks.unheard());
        Set<String> late = new HashSet<>(outputs);
        late.removeIf(each -> !timing.isByEvents() && !timing.isDelayed(each));
        return late;
    }

    /** What is done before a behaviour begins, where it stands beside it or around it. */
    Optional<BlockContext> before(List<Side> sides) {
        for (Placed each : elements) {
            if (each.element() instanceof InitElementContext init && each.goesWith(sides)) {
                if (sides.containsAll(each.sides())) {
                    return Optional.of(init.block());
                }
                lacks.missing(
                        Lack.VARIABILITY,
                        init,
                        "'init' is there in some variants of what it begins only; write it"
                                + " beside that");
            }
        }
        return Optional.empty();
    }

    /** Whether something is done after 'init'. */
    boolean goOn(Placed init) {
        return behaviours.stream().anyMatch(each -> each.goesWith(init.sides()));
    }
}
