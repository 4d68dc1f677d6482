package arcomat.pipeline.check;

import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.pipeline.WrongUse;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * One side of a question, as it is written: {@code p.Robot}, {@code p.Timer(2)}, or one automaton
 * of several, {@code p.Robot#waits}.
 *
 * @param automaton empty where the whole component is meant
 */
public record PromiseReference(String component, Optional<String> automaton) {

    /** Takes what was written apart; whether it exists is not asked. */
    public static PromiseReference parse(String written) {
        int hash = written.indexOf('#');
        return hash < 0
                ? new PromiseReference(written, Optional.empty())
                : new PromiseReference(
                        written.substring(0, hash), Optional.of(written.substring(hash + 1)));
    }

    /**
     * What the component does; with an automaton, what that one asks.
     *
     * @throws WrongUse where there is no such component or automaton
     */
    public Promise in(LoweredModels models) throws WrongUse {
        return of(MainComponent.find(component, models));
    }

    /**
     * As above; of a component that needs arguments, where none are written, what it does with each
     * list of arguments that is known.
     *
     * @param known arguments of a component
     */
    public List<Promise> in(
            LoweredModels models, Function<Component, Collection<List<Value>>> known)
            throws WrongUse {
        List<Promise> promises = new ArrayList<>();
        for (MainComponent each : MainComponent.find(component, models, known)) {
            promises.add(of(each));
        }
        return promises;
    }

    private Promise of(MainComponent main) throws WrongUse {
        Promise promise = Promise.of(main.component(), main.arguments());
        if (automaton.isEmpty()) {
            return promise;
        }
        String name = automaton.get();
        if (name.isEmpty()) {
            throw new WrongUse(
                    "the name of an automaton is missing behind '#' in '%s#'; %s",
                    component, named(main.component()));
        }
        return promise.only(name)
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "component '%s' has no automaton '%s'; %s",
                                        main.component().qualifiedName(),
                                        name,
                                        named(main.component())));
    }

    /**
     * The same, but of a decomposed component what the automata on it ask, not what its parts do.
     */
    public Promise automataIn(LoweredModels models) throws WrongUse {
        Promise promise = in(models);
        return promise.automata().isEmpty()
                ? Promise.required(promise.component(), promise.arguments())
                : promise;
    }

    private static String named(Component component) {
        List<String> names =
                component.automata().stream().map(a -> a.name()).filter(n -> !n.isEmpty()).toList();
        return names.isEmpty()
                ? "none of its automata has a name"
                : "there are " + names.stream().collect(Collectors.joining(", "));
    }
}
