package arcomat.analysis.automaton;

import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.RunProperty.Difference;
import arcomat.analysis.smt.Subject;
import arcomat.model.Automaton;
import arcomat.semantics.expression.Fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** All that may be asked about an automaton, and how to say it. */
record Questions(Subject subject) {

    /** Whatever an analysis wants to know, what others depend on first. */
    List<RunProperty> all() {
        List<RunProperty> all = new ArrayList<>();
        int states = subject.automaton().states().size();
        int transitions = subject.automaton().transitions().size();
        for (int state = 0; state < states; state++) {
            all.add(new RunProperty.Reached(state));
        }
        for (int transition = 0; transition < transitions; transition++) {
            all.add(new RunProperty.Enabled(transition));
            for (Fault.Kind kind : Fault.Kind.values()) {
                all.add(new RunProperty.Wrong(transition, kind));
            }
            if (subject.preconditions().get(transition).mayWrap()) {
                all.add(new RunProperty.Overflow(transition));
            }
        }
        bySource().values().forEach(leaving -> addTogether(leaving, all));
        if (subject.automaton().completion() != Automaton.Completion.IGNORE) {
            for (int state = 0; state < states; state++) {
                all.add(new RunProperty.Unhandled(state, false));
                all.add(new RunProperty.Unhandled(state, true));
            }
        }
        return all;
    }

    private Map<Integer, List<Integer>> bySource() {
        return IntStream.range(0, subject.automaton().transitions().size())
                .boxed()
                .collect(
                        Collectors.groupingBy(
                                transition -> subject.transition(transition).source(),
                                TreeMap::new,
                                Collectors.toList()));
    }

    private static void addTogether(List<Integer> leaving, List<RunProperty> all) {
        for (int i = 0; i < leaving.size(); i++) {
            for (int second : leaving.subList(i + 1, leaving.size())) {
                for (Difference difference : Difference.values()) {
                    all.add(new RunProperty.Together(leaving.get(i), second, difference));
                }
            }
        }
    }

    /** What is asked, to follow "whether". */
    String words(RunProperty question) {
        if (question instanceof RunProperty.Reached reached) {
            return "state " + subject.state(reached.state()) + " is reached";
        }
        if (question instanceof RunProperty.Enabled enabled) {
            return "transition " + subject.place(enabled.transition()) + " can be taken";
        }
        if (question instanceof RunProperty.Together together) {
            return "transitions "
                    + subject.place(together.first())
                    + " and "
                    + subject.place(together.second())
                    + " can be enabled together"
                    + difference(together.difference());
        }
        if (question instanceof RunProperty.Unhandled unhandled) {
            return (unhandled.silent() ? "silence" : "every message")
                    + " is handled in "
                    + subject.state(unhandled.state());
        }
        if (question instanceof RunProperty.Wrong wrong) {
            return "transition "
                    + subject.place(wrong.transition())
                    + (wrong.kind() == Fault.Kind.DIVISION_BY_ZERO
                            ? " can divide by zero"
                            : " can leave a range");
        }
        int transition = ((RunProperty.Overflow) question).transition();
        return "an integer of transition " + subject.place(transition) + " can overflow";
    }

    private static String difference(Difference difference) {
        return switch (difference) {
            case ANY -> "";
            case OUTPUT -> " with different outputs";
            case TARGET -> " with different targets";
        };
    }
}
