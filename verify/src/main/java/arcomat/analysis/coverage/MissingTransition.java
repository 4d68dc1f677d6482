package arcomat.analysis.coverage;

import arcomat.analysis.coverage.ReachabilityGraph.Node;
import arcomat.analysis.coverage.ReachabilityGraph.Step;
import arcomat.analysis.search.Budget;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Output;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A component as it would be without one of its transitions: whether it could have been taken for
 * the whole one in a run, and how long to go on until it cannot.
 */
record MissingTransition(
        ReachabilityGraph graph, ComponentSemantics behaviour, Goal missing, Budget budget) {
    /** So many ways to go on are tried. */
    private static final int MOST_TRIED = 300;

    private record Way(Node node, Set<List<Configuration>> places) {}

    private record Arrival(Way way, @Nullable Arrival before, @Nullable Step last) {}

    /**
     * A short way to go on after a run that shows the absence.
     *
     * @return empty where the run itself shows it, and where no way was found that does
     */
    List<Step> noticed(List<Step> word) {
        Set<List<Configuration>> places = new LinkedHashSet<>();
        behaviour.starts(budget::insist).forEach(start -> places.add(start.configurations()));
        Optional<Set<List<Configuration>>> after = Optional.of(places);
        for (Step step : word) {
            after = after.flatMap(before -> advance(before, step));
        }
        if (after.isEmpty() || after.get().isEmpty()) {
            return List.of();
        }
        return search(new Way(word.get(word.size() - 1).to(), after.get()));
    }

    private List<Step> search(Way first) {
        Deque<Arrival> waiting = new ArrayDeque<>();
        Set<Way> seen = new HashSet<>();
        waiting.add(new Arrival(first, null, null));
        while (!waiting.isEmpty() && seen.size() < MOST_TRIED) {
            Arrival arrival = waiting.remove();
            for (Step step : graph.steps(arrival.way.node)) {
                Optional<Set<List<Configuration>>> places = advance(arrival.way.places, step);
                if (places.isEmpty()) {
                    continue;
                }
                Way way = new Way(step.to(), places.get());
                Arrival next = new Arrival(way, arrival, step);
                if (way.places.isEmpty()) {
                    return steps(next);
                }
                if (seen.add(way)) {
                    waiting.add(next);
                }
            }
        }
        return List.of();
    }

    private static List<Step> steps(Arrival last) {
        Deque<Step> steps = new ArrayDeque<>();
        for (Arrival arrival = last;
                arrival != null && arrival.last != null;
                arrival = arrival.before) {
            steps.addFirst(arrival.last);
        }
        return List.copyOf(steps);
    }

    /** Where it may be after it was seen to take a step; empty if it may do as it likes. */
    private Optional<Set<List<Configuration>>> advance(Set<List<Configuration>> places, Step step) {
        if (step.input().isEmpty()) {
            return Optional.of(places);
        }
        Set<List<Configuration>> after = new LinkedHashSet<>();
        for (List<Configuration> place : places) {
            for (Partial way : ways(place, step.input().get())) {
                if (allows(way.output, step.sent())) {
                    after.add(way.next);
                }
            }
        }
        boolean lost = after.stream().anyMatch(place -> place.contains(Configuration.CHAOS));
        return lost ? Optional.empty() : Optional.of(after);
    }

    /** Some automata have reacted. */
    private record Partial(List<Configuration> next, Output output) {
        Optional<Partial> and(Reaction reaction) {
            List<Configuration> longer = new ArrayList<>(next);
            longer.add(reaction.next());
            return output.meet(reaction.output()).map(both -> new Partial(longer, both));
        }
    }

    private List<Partial> ways(List<Configuration> place, Input input) {
        int outputs = behaviour.component().outputs().size();
        List<Partial> ways = List.of(new Partial(List.of(), Output.anything(outputs)));
        for (int i = 0; i < place.size(); i++) {
            List<Partial> longer = new ArrayList<>();
            for (Reaction reaction : reactions(behaviour.relations().get(i), place.get(i), input)) {
                if (reaction.next() != Configuration.ERROR) {
                    budget.insist();
                    ways.forEach(way -> way.and(reaction).ifPresent(longer::add));
                }
            }
            ways = longer;
        }
        return ways;
    }

    private List<Reaction> reactions(StepRelation relation, Configuration before, Input input) {
        StepRelation.Prospect all = relation.prospect(before, input);
        List<Reaction> reactions =
                all.reactions().stream()
                        .filter(each -> !isMissing(relation, each.cause()))
                        .toList();
        boolean goesWrong =
                all.errors().stream().anyMatch(each -> !isMissing(relation, each.cause()));
        return reactions.isEmpty() && !goesWrong ? List.of(relation.complete(before)) : reactions;
    }

    private boolean isMissing(StepRelation relation, Trace.Cause cause) {
        return cause instanceof Trace.Taken taken
                && new Goal(relation.automaton(), taken.index()).equals(missing);
    }

    private boolean allows(Output output, Letter sent) {
        List<Port> ports = behaviour.component().outputs();
        for (int i = 0; i < ports.size(); i++) {
            if (!output.ports().get(i).allows(sent.messages(ports.get(i).name()))) {
                return false;
            }
        }
        return true;
    }
}
