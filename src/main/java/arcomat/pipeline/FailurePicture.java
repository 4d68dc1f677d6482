package arcomat.pipeline;

import arcomat.analysis.Moment;
import arcomat.analysis.Promise;
import arcomat.analysis.Verdict;
import arcomat.diagram.AutomatonGraph;
import arcomat.diagram.FailureGraph;
import arcomat.diagram.Graph;
import arcomat.diagram.Highlights;
import arcomat.diagram.Highlights.Highlight;
import arcomat.diagram.Highlights.Kind;
import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Letter;
import arcomat.model.Value;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** What is to be drawn of a failed comparison: the run, and its way through both automata. */
final class FailurePicture {
    private FailurePicture() {}

    /** Of a verdict that fails with a run. */
    static Graph of(Promise left, Promise right, Verdict verdict) {
        List<Moment> trace = verdict.trace();
        List<FailureGraph.Step> steps = trace.stream().map(FailurePicture::step).toList();
        String title = left.title() + " does not refine " + right.title();
        return FailureGraph.of(
                title,
                steps,
                side(left, "left: ", trace, moment -> List.of(moment.left())),
                side(right, "right: ", trace, Moment::right));
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
        letters.add("/ " + (moment.error() ? "error" : sent.isEmpty() ? "--" : sent.get(0)));
        letters.addAll(sent.subList(Math.min(1, sent.size()), sent.size()));
        return new FailureGraph.Step(letters, moment.left(), moment.right());
    }

    private static String text(List<Value> values) {
        return values.size() == 1 ? values.get(0).toString() : values.toString();
    }

    /** The automaton of a side, with the numbers of the steps at its states and transitions. */
    private static Optional<Graph> side(
            Promise side, String which, List<Moment> trace, Function<Moment, List<String>> where) {
        if (side.automata().size() != 1) {
            return Optional.empty();
        }
        List<List<String>> places = trace.stream().map(where).toList();
        Automaton automaton = side.automata().get(0);
        Map<Integer, List<Highlight>> states = new LinkedHashMap<>();
        Map<Integer, List<Highlight>> transitions = new LinkedHashMap<>();
        for (int i = 0; i < trace.size(); i++) {
            boolean forbidden = places.get(i).isEmpty();
            List<Integer> now = indices(automaton, places.get(i));
            List<Integer> before = i == 0 ? List.of() : indices(automaton, places.get(i - 1));
            Highlight step = new Highlight(Kind.ACTIVE, "step " + i, "");
            now.forEach(state -> add(states, state, step));
            for (int t = 0; t < automaton.transitions().size(); t++) {
                Automaton.Transition each = automaton.transitions().get(t);
                boolean moves = before.contains(each.source()) && now.contains(each.target());
                if (moves && mayRead(each, trace.get(i).input())) {
                    add(transitions, t, step);
                }
            }
            if (forbidden) {
                String tag = "no step " + i;
                before.forEach(state -> add(states, state, new Highlight(Kind.PROBLEM, tag, "")));
            }
        }
        Highlights highlights = new Highlights(states, transitions);
        return Optional.of(AutomatonGraph.of(which + side.title(), automaton, highlights));
    }

    private static void add(Map<Integer, List<Highlight>> map, int index, Highlight highlight) {
        map.computeIfAbsent(index, key -> new ArrayList<>()).add(highlight);
    }

    /** States by what the analysis calls them: the name, and the values of variables behind it. */
    private static List<Integer> indices(Automaton automaton, List<String> places) {
        List<Integer> indices = new ArrayList<>();
        for (String place : places) {
            int state = automaton.states().indexOf(place.split(" \\(", 2)[0]);
            if (state >= 0 && !indices.contains(state)) {
                indices.add(state);
            }
        }
        return indices;
    }

    /** Whether the input block agrees with a letter, as far as it asks for constants. */
    private static boolean mayRead(Automaton.Transition transition, Letter letter) {
        return transition.matches().stream()
                .allMatch(match -> agrees(match.pattern(), letter.messages(match.port().name())));
    }

    private static boolean agrees(Automaton.Pattern pattern, List<Value> messages) {
        if (pattern instanceof Automaton.Absent) {
            return messages.isEmpty();
        }
        if (pattern instanceof Automaton.OneOf oneOf && !messages.isEmpty()) {
            return oneOf.values().stream()
                    .anyMatch(
                            value ->
                                    !(value instanceof Expression.Constant constant)
                                            || constant.value().equals(messages.get(0)));
        }
        return !messages.isEmpty();
    }
}
