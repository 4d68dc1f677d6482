package arcomat.report.verdict;

import arcomat.analysis.coverage.Goal;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.List;
import java.util.Optional;

/**
 * Tests that were made, for programs.
 *
 * @param suite the file where they were written; empty where there are none
 */
public record TransitionTestsJson(
        String verdict,
        String reason,
        String suite,
        List<Test> tests,
        List<NotTaken> notTaken,
        List<NotTold> notTold,
        Explored explored) {

    record Test(
            String name,
            int letters,
            List<Transition> takes,
            boolean promised,
            Optional<Mistake> tells) {
        static Test of(TransitionTests.Test test) {
            return new Test(
                    test.streams().name(),
                    test.streams().inputs().size(),
                    test.covers().stream().map(Transition::of).toList(),
                    test.promised(),
                    test.tells().map(Mistake::of));
        }
    }

    record Transition(String automaton, String from, String to, int line) {
        static Transition of(Goal goal) {
            return new Transition(
                    goal.automaton().name(),
                    goal.source(),
                    goal.target(),
                    goal.transition().span().startPosition().line());
        }
    }

    record Mistake(@JsonUnwrapped Transition transition, String mistake) {
        static Mistake of(TransitionTests.Mistake mistake) {
            return new Mistake(Transition.of(mistake.transition()), mistake.what());
        }
    }

    record NotTaken(@JsonUnwrapped Transition transition, String reason) {
        static NotTaken of(TransitionTests.Uncovered uncovered) {
            return new NotTaken(Transition.of(uncovered.transition()), uncovered.reason());
        }
    }

    record NotTold(@JsonUnwrapped Mistake mistake, String reason, boolean certain) {
        static NotTold of(TransitionTests.Untold untold) {
            return new NotTold(Mistake.of(untold.mistake()), untold.reason(), untold.certain());
        }
    }

    record Explored(int configurations) {}

    /**
     * @param file where the tests were written; empty where there are none
     */
    public static String render(String file, TransitionTests.Result found) {
        return Json.text(
                new TransitionTestsJson(
                        Printable.word(found.answer()),
                        found.stopped().orElse(""),
                        file,
                        found.tests().stream().map(Test::of).toList(),
                        found.uncovered().stream().map(NotTaken::of).toList(),
                        found.untold().stream().map(NotTold::of).toList(),
                        new Explored(found.configurations())));
    }
}
