package arcomat.analysis.automaton;

import arcomat.analysis.automaton.Situation.Alternative;
import arcomat.analysis.smt.Subject;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.source.Diagnostic;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.stream.Collectors;

/**
 * States from which no transition that sends can be reached; completions are left aside. With
 * variables it is a matter of configurations: a counter that has run out may be a trap.
 */
final class Trap implements Analysis {
    static final String CODE = "ARC1005";

    private final Subject subject;
    private final Story story;
    private final List<IntArrayList> before = new ArrayList<>();
    private final BitSet sending = new BitSet();

    Trap(Subject subject) {
        this.subject = subject;
        this.story = new Story(subject);
    }

    @Override
    public void see(Situation situation) {
        int number = situation.visit().number();
        if (number < 0) {
            return; // found by the solver: not all is seen, and nothing is claimed
        }
        if (!situation.faults().isEmpty()) {
            sending.set(number); // a run ends in an error there, and that is found elsewhere
        }
        for (Alternative each : situation.alternatives()) {
            if (sends(subject, each.taken().transition()) || each.fault().isPresent()) {
                sending.set(number);
            }
            if (each.next() >= 0) {
                while (before.size() <= each.next()) {
                    before.add(new IntArrayList(1));
                }
                before.get(each.next()).add(number);
            }
        }
    }

    /** Whether a transition may send. */
    static boolean sends(Subject subject, Automaton.Transition transition) {
        return subject.automaton().omitted() == Automaton.Omitted.FREE
                || transition.sends().stream()
                        .anyMatch(send -> !(send.emission() instanceof Automaton.Silence));
    }

    @Override
    public List<Finding> findings(Knowledge knowledge) {
        Exploration explored = knowledge.explored();
        if (!knowledge.isExhaustive() || !isToSend(subject)) {
            return List.of();
        }
        BitSet trapped = new BitSet();
        trapped.set(0, explored.size());
        trapped.andNot(thoseThatMaySend());
        return TrapGroup.of(trapped, before, explored).stream().map(this::finding).toList();
    }

    /** Not one of several requirements that says nothing about outputs. */
    static boolean isToSend(Subject subject) {
        Component component = subject.component();
        boolean sole =
                component.body() instanceof Component.Atomic atomic
                        && atomic.automata().size() == 1;
        return sole
                ? !component.outputs().isEmpty()
                : subject.automaton().transitions().stream()
                        .anyMatch(transition -> sends(subject, transition));
    }

    private BitSet thoseThatMaySend() {
        BitSet may = (BitSet) sending.clone();
        Deque<Integer> open = new ArrayDeque<>();
        sending.stream().forEach(open::add);
        while (!open.isEmpty()) {
            int number = open.remove();
            IntArrayList earlier = number < before.size() ? before.get(number) : new IntArrayList();
            for (int i = 0; i < earlier.size(); i++) {
                if (!may.get(earlier.get(i))) {
                    may.set(earlier.get(i));
                    open.add(earlier.get(i));
                }
            }
        }
        return may;
    }

    private Finding finding(TrapGroup group) {
        Visit entry = group.entry();
        String states =
                group.states().stream().map(subject::state).collect(Collectors.joining(", "));
        String among = group.states().size() == 1 ? "" : "; the trap is {" + states + "}";
        Diagnostic diagnostic =
                Diagnostic.warning(
                        CODE,
                        subject.automaton().places().get(entry.configuration().state()),
                        "from %s on nothing is sent any more: no transition that sends can be taken%s"
                                .formatted(story.words(entry.configuration()), among));
        return story.finding(diagnostic, entry);
    }
}
