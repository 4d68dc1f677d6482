package arcomat.pipeline.check;

import arcomat.analysis.Promise;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.step.WrongUse;

import java.util.List;
import java.util.stream.Collectors;

/**
 * One side of a question, as it is written: {@code p.Robot}, {@code p.Timer(2)}, or one automaton
 * of several, {@code p.Robot#waits}.
 */
public record PromiseReference(String component, String automaton) {

    /** Takes what was written apart; whether it exists is not asked. */
    public static PromiseReference parse(String written) {
        int hash = written.indexOf('#');
        return hash < 0
                ? new PromiseReference(written, "")
                : new PromiseReference(written.substring(0, hash), written.substring(hash + 1));
    }

    /**
     * What the component does; with an automaton, what that one asks.
     *
     * @throws WrongUse where there is no such component or automaton
     */
    public Promise in(CheckedModels checked, Model model) throws WrongUse {
        MainComponent main = MainComponent.find(component, checked, model);
        Promise promise = Promise.of(main.component(), main.arguments());
        if (automaton.isEmpty()) {
            return promise;
        }
        return promise.only(automaton)
                .orElseThrow(
                        () ->
                                new WrongUse(
                                        "component '"
                                                + main.component().qualifiedName()
                                                + "' has no automaton '"
                                                + automaton
                                                + "'; "
                                                + named(main.component())));
    }

    private static String named(Component component) {
        List<String> names =
                component.automata().stream().map(a -> a.name()).filter(n -> !n.isEmpty()).toList();
        return names.isEmpty()
                ? "none of its automata has a name"
                : "there are " + names.stream().collect(Collectors.joining(", "));
    }
}
