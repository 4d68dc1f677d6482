package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.RunProperties;
import arcomat.analysis.automaton.induction.Strengthening;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Budget;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * On random small automata, what solvers say with what always holds in each state is what trying
 * everything says.
 */
class StrengtheningTest {
    private static final int AUTOMATA = Integer.getInteger("strengthening.automata", 12);
    private static final int SEED = Integer.getInteger("strengthening.seed", 1);

    private static final Budget NO_STATES = Budget.ofMemory().atMost(-1);

    private int asked;
    private int decided;
    private int impossible;

    @Tag("slow")
    @Test
    void agreesWithTryingEverything() {
        for (long seed = SEED; seed < SEED + AUTOMATA; seed++) {
            boolean one = seed % 3 > 0;
            compare(
                    one ? RandomTraps.subject(seed, false) : RandomTraps.ofTwoBeginnings(seed),
                    seed);
        }
        assertThat(decided).as("decided").isGreaterThan(asked * 95 / 100);
        assertThat(impossible).as("impossible").isGreaterThan(asked / 5);
    }

    private void compare(Subject subject, long seed) {
        Exploration all = new Exploration(subject, situation -> {}, Budget.ofMemory());
        all.run();
        assertThat(all.isComplete()).isTrue();
        Knowledge known = Strengthening.of(unexplored(subject), situation -> {}, Budget.ofMemory());
        List<RunProperty> questions = new RunProperties(subject).all();
        for (RunProperty question : questions) {
            String about = "%s of %d".formatted(new RunProperties(subject).words(question), seed);
            if (known.neverHappens(question)) {
                assertThat(all.shown()).as(about).doesNotContain(question);
                impossible++;
            } else if (known.happens(question)) {
                assertThat(all.shown()).as(about).contains(question);
            }
        }
        asked += questions.size();
        decided += questions.size() - known.unknown().size();
    }

    /** As if there were no end of configurations, and nothing had been asked yet. */
    private static Knowledge unexplored(Subject subject) {
        Exploration explored = new Exploration(subject, situation -> {}, NO_STATES);
        explored.run();
        Map<RunProperty, Reachability> open = new LinkedHashMap<>();
        new RunProperties(subject)
                .all()
                .forEach(each -> open.put(each, new Reachability.Unknown("it was not asked")));
        return new Knowledge(subject, explored, Set.of(), open);
    }
}
