package arcomat.laws;

import arcomat.laws.Law.Outcome;
import arcomat.semantics.value.GivenUp;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.NoSuchElementException;
import java.util.Optional;

/** A law on models that come from anywhere: what throws breaks it, too. */
final class Trial {
    private Trial() {}

    /** Empty where the models are not well-formed, or are not there. */
    static Optional<Outcome> check(Law law, List<SourceFile> files, int seed) {
        try {
            return law.checkText(files, seed);
        } catch (GivenUp stopped) {
            return Optional.of(Outcome.SKIPPED);
        } catch (RuntimeException | AssertionError | StackOverflowError thrown) {
            return isOutside(thrown)
                    ? Optional.empty()
                    : Optional.of(
                            Outcome.broken(
                                    "throws "
                                            + thrown.getClass().getSimpleName()
                                            + ": "
                                            + at(thrown)));
        }
    }

    /** A component that a law asks for is missing, or a text that is smaller cannot be parsed. */
    private static boolean isOutside(Throwable thrown) {
        StackTraceElement[] stack = thrown.getStackTrace();
        return stack.length > 1
                && (thrown instanceof NoSuchElementException
                                && stack[1].getClassName().equals(Models.class.getName())
                        || thrown instanceof AssertionError
                                && stack[0].getClassName().endsWith(".ReadModels"));
    }

    private static String at(Throwable thrown) {
        StringBuilder text = new StringBuilder(String.valueOf(thrown.getMessage()));
        for (StackTraceElement each :
                List.of(thrown.getStackTrace())
                        .subList(0, Math.min(4, thrown.getStackTrace().length))) {
            text.append(" at ").append(each);
        }
        return text.toString();
    }
}
