package arcomat.pipeline.watch;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.pipeline.check.CheckResult;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Verdict;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What is known of the models now. What a change may have touched is not in here any more until it
 * has been asked again.
 *
 * @param check of all files
 * @param tests of all suites that were run on the models as they are
 * @param promises of all components, where they were asked of the models as they are
 * @param worlds that were run with the models as they are
 * @param states how far each step is
 * @param trouble an error of the tool that kept a step from its answer
 */
public record WatchStatus(
        CheckResult check,
        List<StreamTestResult> tests,
        List<Answered> promises,
        List<WorldEnd> worlds,
        Map<Step, State> states,
        Optional<String> trouble) {

    /** In this order. */
    public enum Step {
        CHECK,
        TEST,
        VERIFY,
        WORLD
    }

    /** How far a step is. */
    public enum State {
        /** Its answers are all there. */
        DONE,

        /** It is asked, or is to be asked when those before it are done. */
        ASKED,

        /** The models have errors that have to be mended before. */
        BLOCKED
    }

    /** How it stands: what a process ends with. */
    public enum Standing {
        FINE,
        BROKEN,
        UNKNOWN
    }

    public WatchStatus {
        tests = List.copyOf(tests);
        promises = List.copyOf(promises);
        worlds = List.copyOf(worlds);
        states = new EnumMap<>(states);
    }

    public State state(Step step) {
        return states.getOrDefault(step, State.DONE);
    }

    public Standing standing() {
        boolean broken =
                check.hasErrors()
                        || tests.stream().anyMatch(each -> each.verdict() == Verdict.FAILED)
                        || promises.stream()
                                .anyMatch(each -> each.verdict().answer() == Answer.FAILS)
                        || worlds.stream().anyMatch(each -> !each.succeeded());
        if (broken) {
            return Standing.BROKEN;
        }
        boolean unknown =
                trouble.isPresent()
                        || states.values().stream().anyMatch(each -> each != State.DONE)
                        || tests.stream().anyMatch(each -> each.verdict() == Verdict.UNKNOWN)
                        || promises.stream()
                                .anyMatch(each -> each.verdict().answer() == Answer.UNKNOWN);
        return unknown ? Standing.UNKNOWN : Standing.FINE;
    }
}
