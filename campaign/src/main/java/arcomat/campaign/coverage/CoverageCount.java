package arcomat.campaign.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Counts the runs that came to each item. A million runs take it no more memory than one. */
public final class CoverageCount {
    private final CoverageItems items;
    private final List<Counts> automata = new ArrayList<>();
    private final List<Counts> parts = new ArrayList<>();
    private long runs;

    public CoverageCount(CoverageItems items) {
        this.items = items;
        for (int i = 0; i < items.automata().size(); i++) {
            automata.add(new Counts(items.automata().get(i), items.ofAutomaton(i)));
        }
        List<ItemNumbers> numbers = items.ofParts();
        for (int i = 0; i < numbers.size(); i++) {
            int automaton = items.parts().get(i).automaton();
            parts.add(new Counts(items.automata().get(automaton), numbers.get(i)));
        }
    }

    /** The next run. */
    public void see(ReachedItems reached) {
        if (reached.isKnown()) {
            runs++;
            automata.forEach(each -> each.see(reached));
            parts.forEach(each -> each.see(reached));
        }
    }

    public Coverage coverage() {
        List<List<Coverage.OfPart>> own = new ArrayList<>();
        automata.forEach(each -> own.add(new ArrayList<>()));
        for (int i = 0; i < parts.size(); i++) {
            PartItems part = items.parts().get(i);
            Counts counts = parts.get(i);
            own.get(part.automaton())
                    .add(
                            new Coverage.OfPart(
                                    part,
                                    counts.numbers.transition(),
                                    counts.transitions(),
                                    counts.states()));
        }
        List<Coverage.OfAutomaton> all = new ArrayList<>();
        for (int i = 0; i < automata.size(); i++) {
            Counts counts = automata.get(i);
            all.add(
                    new Coverage.OfAutomaton(
                            counts.items, counts.transitions(), counts.states(), own.get(i)));
        }
        return new Coverage(runs, all, items.jars());
    }

    /** Of one automaton, in one part or in whichever. */
    private static final class Counts {
        private final AutomatonItems items;
        private final ItemNumbers numbers;
        private final long[] transitions;
        private final long[] states;
        private final boolean[] visited;

        Counts(AutomatonItems items, ItemNumbers numbers) {
            this.items = items;
            this.numbers = numbers;
            transitions = new long[items.transitions().size()];
            states = new long[items.states().size()];
            visited = new boolean[states.length];
        }

        void see(ReachedItems reached) {
            Arrays.fill(visited, false);
            for (int i = 0; i < transitions.length; i++) {
                if (reached.contains(numbers.transition() + i)) {
                    transitions[i]++;
                    visited[items.transitions().get(i).target()] = true;
                }
            }
            for (int i = 0; i < items.initials().size(); i++) {
                if (reached.contains(numbers.initial() + i)) {
                    visited[items.initials().get(i)] = true;
                }
            }
            for (int i = 0; i < states.length; i++) {
                states[i] += visited[i] ? 1 : 0;
            }
        }

        List<Long> transitions() {
            return Arrays.stream(transitions).boxed().toList();
        }

        List<Long> states() {
            return Arrays.stream(states).boxed().toList();
        }
    }
}
