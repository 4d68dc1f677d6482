package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.model.Automaton;
import arcomat.model.Model;
import arcomat.model.Refusal;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.Visited;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Ways of counterexamples as data: {@code verify/src/test/resources/analysis/trace-replay.txt}.
 * Below {@code == trace A B} stands a line for each automaton of both sides, with the states that
 * it is in after each moment, {@code --} for none, and, behind {@code by}, the transitions to
 * there; the initial clauses have numbers. Below {@code == anywhere A B} stand the ways of those of
 * B where nobody says where they are. Below {@code == nearest A B} stands, moment by moment, why no
 * transition was enabled, for each automaton as below {@code == trace A B}.
 */
class TraceReplayTest {
    private static final Path DATA = Path.of("verify/src/test/resources/analysis/trace-replay.txt");

    @TestFactory
    Stream<DynamicTest> ways() {
        Sections sections = Sections.read(DATA);
        Model model = sections.model();
        return sections.all().stream()
                .filter(each -> !each.kind().equals("file"))
                .map(each -> DynamicTest.dynamicTest(each.rest(), () -> check(model, each)));
    }

    private static void check(Model model, Sections.Section asked) {
        String[] names = asked.rest().split(" ");
        Promise left = VerdictsTest.promise(model, names[0], '-');
        Promise right = VerdictsTest.promise(model, names[1], '-');
        List<Moment> trace = Refinement.check(left, right, Budget.ofMemory()).trace();
        assertThat(trace).isNotEmpty();
        List<String> lines = new ArrayList<>();
        if (asked.kind().equals("trace")) {
            List<Promise> sides = List.of(left, right);
            left.automata().forEach(a -> lines.add(text(a, TraceReplay.of(sides, 0, a, trace))));
            right.automata().forEach(a -> lines.add(text(a, TraceReplay.of(sides, 1, a, trace))));
        } else if (asked.kind().equals("nearest")) {
            List<Promise> sides = List.of(left, right);
            left.automata().forEach(a -> lines.add(nearest(TraceReplay.of(sides, 0, a, trace))));
            right.automata().forEach(a -> lines.add(nearest(TraceReplay.of(sides, 1, a, trace))));
        } else {
            right.automata()
                    .forEach(a -> lines.add(text(a, TraceReplay.anywhere(right, a, trace))));
        }
        assertThat(lines).isEqualTo(asked.lines());
    }

    private static String text(Automaton automaton, List<Visited> visited) {
        return visited.stream()
                .map(each -> text(automaton, each))
                .collect(Collectors.joining(" | "));
    }

    private static String text(Automaton automaton, Visited visited) {
        String by =
                words(visited.initials(), String::valueOf)
                        + words(visited.transitions(), i -> move(automaton, i));
        String states = words(visited.states(), automaton.states()::get);
        return (states.isEmpty() ? "--" : states) + (by.isEmpty() ? "" : " by " + by);
    }

    private static String nearest(List<Visited> visited) {
        return visited.stream()
                .map(each -> each.nearest().stream().map(Refusal::words).toList())
                .map(each -> each.isEmpty() ? "--" : String.join(" or ", each))
                .collect(Collectors.joining(" | "));
    }

    private static String move(Automaton automaton, int transition) {
        Automaton.Transition taken = automaton.transitions().get(transition);
        return automaton.states().get(taken.source())
                + " -> "
                + automaton.states().get(taken.target());
    }

    private static String words(Set<Integer> numbers, IntFunction<String> word) {
        return numbers.stream().map(word::apply).collect(Collectors.joining(", "));
    }
}
