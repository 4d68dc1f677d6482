package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.RunProperties;
import arcomat.analysis.automaton.exploration.Traps;
import arcomat.analysis.automaton.trap.TrapSearch;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * On random small automata, solvers that know nothing else find the traps that trying all letters
 * finds, with runs that are as short.
 */
class TrapSearchTest {
    private static final int AUTOMATA = 12;

    private static final Budget NO_STATES = Budget.ofMemory().atMost(-1);

    @Tag("slow")
    @Test
    void agreesWithTryingEverything() {
        compare(1, AUTOMATA);
    }

    static void compare(long seed, int automata) {
        int decided = 0;
        int free = 0;
        int late = 0;
        for (long each = seed; each < seed + automata; each++) {
            Subject subject = RandomTraps.subject(each, false);
            Optional<Integer> exact = NaiveTraps.lettersIntoATrap(subject);
            Traps found = TrapSearch.of(unexplored(subject), Budget.ofMemory());
            Optional<Integer> shortest =
                    found.entered().stream()
                            .map(entry -> entry.visit().length())
                            .min(Integer::compare);
            String about = "seed " + each + " of\n" + new RandomTraps(each, false).text();
            if (found.obstacle().isEmpty()) {
                assertThat(shortest).as(about).isEqualTo(exact);
                decided++;
            } else if (shortest.isPresent()) {
                assertThat(exact).as(about).isPresent();
                assertThat(shortest.get()).as(about).isGreaterThanOrEqualTo(exact.get());
            }
            free += exact.isEmpty() ? 1 : 0;
            late += exact.orElse(0) > 1 ? 1 : 0;
        }
        assertThat(decided).as("decided").isGreaterThanOrEqualTo(automata * 95 / 100);
        assertThat(free).as("without a trap").isGreaterThan(automata / 10);
        assertThat(late).as("with a trap behind some letters").isGreaterThan(automata / 10);
    }

    /** As if there were no end of configurations, and every question but this one left aside. */
    private static Knowledge unexplored(Subject subject) {
        Exploration explored = new Exploration(subject, situation -> {}, NO_STATES);
        explored.run();
        Map<RunProperty, Reachability> open = new HashMap<>();
        new RunProperties(subject)
                .all()
                .forEach(each -> open.put(each, new Reachability.Unknown("it is left aside")));
        return new Knowledge(subject, explored, Set.of(), open);
    }
}
