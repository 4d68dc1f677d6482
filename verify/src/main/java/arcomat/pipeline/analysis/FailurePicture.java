package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.TraceReplay;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Moment;
import arcomat.diagram.AutomatonGraph;
import arcomat.diagram.FailureGraph;
import arcomat.diagram.Graph;
import arcomat.diagram.Highlights;
import arcomat.diagram.Highlights.Highlight;
import arcomat.diagram.Highlights.Kind;
import arcomat.model.Automaton;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.Visited;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What is to be drawn of a failed comparison: the run, and its way through both automata. */
public final class FailurePicture {
    private FailurePicture() {}

    /** Of a verdict that fails with a run. */
    public static Graph of(Promise left, Promise right, Verdict verdict) {
        List<Moment> trace = verdict.trace();
        List<FailureGraph.Step> steps = trace.stream().map(FailurePicture::step).toList();
        String title = left.title() + " does not refine " + right.title();
        return FailureGraph.of(
                title,
                steps,
                side(List.of(left, right), 0, trace),
                side(List.of(left, right), 1, trace));
    }

    private static FailureGraph.Step step(Moment moment) {
        List<String> letters = new ArrayList<>();
        moment.input()
                .messages()
                .forEach((port, values) -> letters.add(port + " = " + text(values)));
        List<String> sent = new ArrayList<>();
        moment.outputs()
                .forEach(
                        (port, messages) -> {
                            if (!messages.equals(Sent.SILENCE)) {
                                sent.add(
                                        port
                                                + " = "
                                                + (messages instanceof Sent.Messages
                                                        ? messages
                                                        : "*"));
                            }
                        });
        if (moment.error()) {
            sent.add("error");
        }
        letters.add("/ " + (sent.isEmpty() ? "--" : sent.get(0)));
        letters.addAll(sent.subList(Math.min(1, sent.size()), sent.size()));
        return new FailureGraph.Step(letters, moment.left(), moment.right());
    }

    private static String text(List<Value> values) {
        return values.size() == 1 ? values.get(0).toString() : values.toString();
    }

    /** The automaton of a side, with the numbers of the steps at its states and transitions. */
    private static Optional<Graph> side(List<Promise> sides, int position, List<Moment> trace) {
        Promise side = sides.get(position);
        boolean isLeft = position == 0;
        if (side.automata().size() != 1) {
            return Optional.empty();
        }
        Automaton automaton = side.automata().get(0);
        List<Visited> visited = TraceReplay.of(sides, position, automaton, trace);
        Map<Integer, List<Highlight>> states = new LinkedHashMap<>();
        Map<Integer, List<Highlight>> transitions = new LinkedHashMap<>();
        for (int i = 0; i < trace.size(); i++) {
            Highlight step = new Highlight(Kind.ACTIVE, "step " + i, "");
            visited.get(i).states().forEach(state -> add(states, state, step));
            visited.get(i).transitions().forEach(each -> add(transitions, each, step));
            if (!isLeft && i > 0 && trace.get(i).right().isEmpty()) {
                Highlight stuck = new Highlight(Kind.PROBLEM, "no step " + i, "");
                visited.get(i - 1).states().forEach(state -> add(states, state, stuck));
            }
        }
        Highlights highlights = new Highlights(states, transitions);
        String title = (isLeft ? "left: " : "right: ") + side.title();
        return Optional.of(AutomatonGraph.of(title, automaton, highlights));
    }

    private static void add(Map<Integer, List<Highlight>> map, int index, Highlight highlight) {
        map.computeIfAbsent(index, key -> new ArrayList<>()).add(highlight);
    }
}
