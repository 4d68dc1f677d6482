package arcomat.analysis.refinement;

import arcomat.analysis.search.Moment;
import arcomat.analysis.search.system.ConfigurationText;
import arcomat.model.Automaton;
import arcomat.model.Letter;
import arcomat.model.Refusal;
import arcomat.model.Trace;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.automaton.Visited;
import arcomat.semantics.automaton.WhyNot;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;

/**
 * The way of a trace through an automaton of one of its sides: the moments say in words where a
 * side is, and this finds the states and transitions again that are meant.
 */
public final class TraceReplay {
    private final Promise side;
    private final Set<String> late;
    private final ComponentSemantics behaviour;
    private final StepRelation relation;
    private final WhyNot whyNot;

    /** Collects what is visited, with all that it is made from. */
    private static final class Step {
        private final Set<Configuration> configurations = new LinkedHashSet<>();
        private final Set<Integer> transitions = new LinkedHashSet<>();
        private final Set<Integer> initials = new LinkedHashSet<>();
        private final Set<Refusal> nearest = new LinkedHashSet<>();

        Visited visited() {
            Set<Integer> states = new LinkedHashSet<>();
            for (Configuration each : configurations) {
                if (each.isState()) {
                    states.add(each.state());
                }
            }
            return new Visited(states, transitions, initials, List.copyOf(nearest));
        }
    }

    /**
     * @param late ports on which a reaction stands in the moment after it
     */
    private TraceReplay(Promise side, Automaton automaton, Set<String> late) {
        this.side = side;
        this.late = late;
        behaviour = ComponentSemantics.of(side.component(), List.of(automaton), side.arguments());
        relation = behaviour.relations().get(0);
        whyNot = WhyNot.of(relation);
    }

    /**
     * What is visited per moment; nothing where the words say nothing about the automaton.
     *
     * @param sides of the comparison that the trace comes from, the left one first
     * @param side the position of that with the automaton
     */
    public static List<Visited> of(
            List<Promise> sides, int side, Automaton automaton, List<Moment> trace) {
        if (trace.isEmpty()) {
            return List.of();
        }
        boolean isLeft = side == 0;
        Set<String> late = ComparedSystems.late(sides.get(0), sides.get(1), isLeft);
        return new TraceReplay(sides.get(side), automaton, late)
                .follow(trace, each -> Optional.of(isLeft ? List.of(each.left()) : each.right()));
    }

    /** As {@link #of}, where the moments do not say where a side is: wherever it may be. */
    public static List<Visited> anywhere(Promise side, Automaton automaton, List<Moment> trace) {
        return new TraceReplay(side, automaton, Set.of()).follow(trace, each -> Optional.empty());
    }

    /**
     * What a side sends in each moment in reaction to its input, also where that stands in the
     * moment after it. A port of which nothing is known is missing.
     *
     * @param sides of the comparison that the trace comes from, the left one first
     */
    public static List<Map<String, Sent>> reactions(
            List<Promise> sides, int side, List<Moment> trace) {
        Set<String> late = ComparedSystems.late(sides.get(0), sides.get(1), side == 0);
        return IntStream.range(0, trace.size()).mapToObj(i -> shown(trace, i, late)).toList();
    }

    private List<Visited> follow(
            List<Moment> trace, Function<Moment, Optional<List<String>>> words) {
        List<Visited> found = new ArrayList<>();
        Step last = null;
        for (int i = 0; i < trace.size(); i++) {
            Moment moment = trace.get(i);
            Map<String, Sent> shown = shown(trace, i, late);
            last =
                    last == null
                            ? begin(shown, words.apply(moment))
                            : step(last.configurations, moment.input(), shown, words.apply(moment));
            found.add(last.visited());
        }
        return found;
    }

    /** Where the reaction of a moment is seen; a late one of the last moment is not seen at all. */
    private static Map<String, Sent> shown(List<Moment> trace, int position, Set<String> late) {
        Map<String, Sent> shown = new HashMap<>(trace.get(position).outputs());
        shown.keySet().removeAll(late);
        if (position + 1 < trace.size()) {
            trace.get(position + 1).outputs().entrySet().stream()
                    .filter(each -> late.contains(each.getKey()))
                    .forEach(each -> shown.put(each.getKey(), each.getValue()));
        }
        return shown;
    }

    private Step begin(Map<String, Sent> shown, Optional<List<String>> words) {
        Step step = new Step();
        for (Start start : relation.starts()) {
            if (isMeant(start.configuration(), words) && allows(start.output(), shown)) {
                step.configurations.add(start.configuration());
                step.initials.add(relation.automaton().initials().indexOf(start.initial()));
            }
        }
        return step;
    }

    private Step step(
            Set<Configuration> before,
            Letter letter,
            Map<String, Sent> shown,
            Optional<List<String>> words) {
        Step step = new Step();
        Input input = Input.of(side.component(), letter);
        for (Configuration each : before) {
            nearest(each, input).ifPresent(step.nearest::add);
            for (Reaction reaction : reactions(each, input)) {
                if (isMeant(reaction.next(), words) && allows(reaction.output(), shown)) {
                    step.configurations.add(reaction.next());
                    if (reaction.cause() instanceof Trace.Taken taken) {
                        step.transitions.add(taken.index());
                    }
                }
            }
        }
        return step;
    }

    /** Where something is enabled, nobody asks why something else is not. */
    private Optional<Refusal> nearest(Configuration before, Input input) {
        return before.isState() && relation.choices(before, input).enabled().isEmpty()
                ? whyNot.nearest(before, input)
                : Optional.empty();
    }

    private List<Reaction> reactions(Configuration before, Input input) {
        return before.isState() ? relation.prospect(before, input).reactions() : List.of();
    }

    /** What a moment leaves open, the automaton may leave open, too. */
    private boolean allows(Output output, Map<String, Sent> shown) {
        for (int i = 0; i < output.ports().size(); i++) {
            String port = side.component().outputs().get(i).name();
            Sent sent = shown.get(port);
            Optional<Sent> both =
                    sent == null ? Optional.of(sent(output, i)) : sent.meet(sent(output, i));
            if (both.isEmpty()) {
                return false;
            }
        }
        return true;
    }

    private static Sent sent(Output output, int port) {
        return output.ports().get(port);
    }

    /** Of several automata, the words are listed one after the other. */
    private boolean isMeant(Configuration configuration, Optional<List<String>> words) {
        if (words.isEmpty()) {
            return true;
        }
        String own = ConfigurationText.of(behaviour, List.of(configuration));
        boolean several = side.automata().size() > 1;
        return words.get().stream()
                .anyMatch(
                        each ->
                                several
                                        ? (", " + each + ", ").contains(", " + own + ", ")
                                        : each.equals(own));
    }
}
