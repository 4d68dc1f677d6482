package arcomat.analysis.automaton.exploration;

import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.RunProperty.Difference;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton;
import arcomat.semantics.expression.Fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** All that may be asked about an automaton, and how to say it. */
public record RunProperties(Subject subject) implements RunProperty.Cases<String> {

    /** Whatever an analysis wants to know, what others depend on first. */
    public List<RunProperty> all() {
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
        subject.silenceable().forEach(each -> all.add(new RunProperty.Silenced(each)));
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
    public String words(RunProperty property) {
        return property.match(this);
    }

    @Override
    public String reached(RunProperty.Reached reached) {
        return "state " + subject.state(reached.state()) + " is reached";
    }

    @Override
    public String enabled(RunProperty.Enabled enabled) {
        return "transition " + subject.place(enabled.transition()) + " can be taken";
    }

    @Override
    public String together(RunProperty.Together together) {
        return "transitions %s and %s can be enabled together%s"
                .formatted(
                        subject.place(together.first()),
                        subject.place(together.second()),
                        difference(together.difference()));
    }

    @Override
    public String unhandled(RunProperty.Unhandled unhandled) {
        return (unhandled.silent() ? "silence" : "every message")
                + " is handled in "
                + subject.state(unhandled.state());
    }

    @Override
    public String wrong(RunProperty.Wrong wrong) {
        String problem =
                switch (wrong.kind()) {
                    case DIVISION_BY_ZERO -> "divide by zero";
                    case OUTSIDE_RANGE -> "leave a range";
                };
        return "transition " + subject.place(wrong.transition()) + " can " + problem;
    }

    @Override
    public String overflow(RunProperty.Overflow overflow) {
        return "an integer of transition " + subject.place(overflow.transition()) + " can overflow";
    }

    @Override
    public String silenced(RunProperty.Silenced silenced) {
        return "silence keeps transition %s from answering"
                .formatted(subject.place(silenced.transition()));
    }

    private static String difference(Difference difference) {
        return switch (difference) {
            case ANY -> "";
            case OUTPUT -> " with different outputs";
            case TARGET -> " with different targets";
        };
    }
}
