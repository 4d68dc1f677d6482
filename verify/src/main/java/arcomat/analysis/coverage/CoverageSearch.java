package arcomat.analysis.coverage;

import arcomat.analysis.coverage.ReachabilityGraph.Beginning;
import arcomat.analysis.coverage.ReachabilityGraph.Node;
import arcomat.analysis.coverage.ReachabilityGraph.Step;
import arcomat.analysis.coverage.TransitionTests.Uncovered;
import arcomat.analysis.search.Budget;
import arcomat.semantics.Promise;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What a search, breadth first, has met until every transition was met, or no more was to be met.
 *
 * @param goals the transitions that are asked for, in text order
 * @param reached those that can be taken
 * @param givenUp why the search ended early, if it did
 */
record CoverageSearch(
        ReachabilityGraph graph,
        List<Goal> goals,
        Set<Goal> reached,
        List<Beginning> beginnings,
        Optional<String> givenUp) {

    /**
     * @param promise an atomic component, or some of its automata: then the transitions of these
     */
    static CoverageSearch of(Promise promise, Budget budget) {
        ReachabilityGraph graph = new ReachabilityGraph(promise, budget);
        List<Goal> goals =
                promise.automata().stream().flatMap(each -> Goal.of(each).stream()).toList();
        Set<Goal> reached = new LinkedHashSet<>();
        List<Beginning> beginnings = new ArrayList<>();
        Optional<String> givenUp;
        try {
            beginnings.addAll(graph.beginnings());
            givenUp = explore(graph, beginnings, goals, reached);
        } catch (GivenUp inTheMiddle) {
            givenUp = Optional.of(String.valueOf(inTheMiddle.getMessage()));
        }
        reached.retainAll(goals);
        return new CoverageSearch(graph, goals, reached, beginnings, givenUp);
    }

    /** Adds to what is reached; why that may not be all. */
    private static Optional<String> explore(
            ReachabilityGraph graph,
            List<Beginning> beginnings,
            List<Goal> goals,
            Set<Goal> reached) {
        Deque<Node> waiting = new ArrayDeque<>();
        beginnings.forEach(beginning -> waiting.add(beginning.node()));
        Set<Node> seen = new HashSet<>(waiting);
        while (!waiting.isEmpty() && !reached.containsAll(goals)) {
            Optional<String> exhausted = graph.exhausted();
            if (exhausted.isPresent()) {
                return exhausted;
            }
            for (Step step : graph.steps(waiting.remove())) {
                reached.addAll(step.taken());
                if (seen.add(step.to())) {
                    waiting.add(step.to());
                }
            }
        }
        return Optional.empty();
    }

    /** Why not everything was looked at, by the search and later, where that is so. */
    Optional<String> stopped() {
        return givenUp.or(graph::sampled);
    }

    /** Why a transition has not been met. */
    Uncovered whyNot(Goal goal) {
        return graph.obstacles().of(goal, stopped());
    }
}
