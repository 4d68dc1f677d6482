package arcomat.pipeline.analysis;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.semantics.Promise;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

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
    /**
     * Two sides as they are written.
     *
     * @param completions of both, {@code chaos,output}; empty for what the models say
     * @throws WrongUse where that is no such pair
     */
    public static ComparedSides of(String left, String right, Optional<String> completions)
            throws WrongUse {
        String[] sides = completions.map(pair -> pair.split(",", -1)).orElse(new String[0]);
        if (completions.isPresent() && sides.length != 2) {
            throw new WrongUse(
                    "--completion '" + completions.get() + "' is no pair such as chaos,output");
        }
        return new ComparedSides(left, right, completion(sides, 0), completion(sides, 1));
    }

    /** The same of other components. */
    ComparedSides of(String otherLeft, String otherRight) {
        return new ComparedSides(otherLeft, otherRight, leftCompletion, rightCompletion);
    }

    private static Optional<Completion> completion(String[] sides, int side) throws WrongUse {
        if (sides.length == 0) {
            return Optional.empty();
        }
        String name = sides[side].strip();
        return Optional.of(
                Arrays.stream(Completion.values())
                        .filter(c -> c.name().toLowerCase(Locale.ROOT).equals(name))
                        .findFirst()
                        .orElseThrow(
                                () ->
                                        new WrongUse(
                                                "'%s' is no completion; there are chaos, output,"
                                                        + " ignore and error",
                                                name)));
    }

    Asked asked() {
        return asked(Optional.empty());
    }

    /**
     * As above.
     *
     * @param further a component that is asked for, too
     */
    Asked asked(Optional<String> further) {
        return Asked.components(Stream.concat(Stream.of(left, right), further.stream()).toList());
    }

    Promise left(LoweredModels models) throws WrongUse {
        return promise(left, leftCompletion, models);
    }

    Promise right(LoweredModels models) throws WrongUse {
        return promise(right, rightCompletion, models);
    }

    /**
     * The left side; where it needs arguments and none are written, with those of each of its
     * instances.
     */
    List<Promise> lefts(LoweredModels models) throws WrongUse {
        return PromiseReference.parse(left)
                .in(models, component -> InstanceArguments.in(models.model()).of(component))
                .stream()
                .map(each -> leftCompletion.map(each::with).orElse(each))
                .toList();
    }

    /**
     * The right side; where it needs arguments, none are written, and the left side has as many of
     * the same types, with these.
     */
    Promise right(LoweredModels models, Promise of) throws WrongUse {
        List<Promise> promises =
                PromiseReference.parse(right)
                        .in(
                                models,
                                component ->
                                        types(component).equals(types(of.component()))
                                                ? List.of(of.arguments())
                                                : List.of());
        return rightCompletion.map(promises.get(0)::with).orElse(promises.get(0));
    }

    private static List<Type> types(Component component) {
        return component.parameters().stream().map(Parameter::type).toList();
    }

    private static Promise promise(
            String written, Optional<Completion> completion, LoweredModels models) throws WrongUse {
        Promise promise = PromiseReference.parse(written).in(models);
        return completion.map(promise::with).orElse(promise);
    }
}
