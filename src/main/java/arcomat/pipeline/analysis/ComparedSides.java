package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Promise;
import arcomat.model.Automaton.Completion;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.PromiseReference;

import java.util.List;
import java.util.Optional;

/**
 * Two components that are to be compared.
 *
 * @param left as written: {@code p.Robot}, {@code p.Timer(2)}, or {@code p.Robot#waits}
 * @param right what the left side is to keep
 * @param leftCompletion instead of that of its automata
 * @param rightCompletion instead of that of its automata
 */
public record ComparedSides(
        String left,
        String right,
        Optional<Completion> leftCompletion,
        Optional<Completion> rightCompletion) {
    Asked asked() {
        return Asked.components(List.of(left, right));
    }

    Promise left(LoweredModels models) throws WrongUse {
        return promise(left, leftCompletion, models);
    }

    Promise right(LoweredModels models) throws WrongUse {
        return promise(right, rightCompletion, models);
    }

    private static Promise promise(
            String written, Optional<Completion> completion, LoweredModels models) throws WrongUse {
        Promise promise = PromiseReference.parse(written).in(models);
        return completion.map(promise::with).orElse(promise);
    }
}
