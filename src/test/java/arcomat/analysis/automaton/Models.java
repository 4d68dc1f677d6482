package arcomat.analysis.automaton;

import arcomat.analysis.refinement.Promise;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Value;

import java.util.List;

/** What the analyses say about models. */
final class Models {
    private Models() {}

    /** Of all components with automata; parameters without a default have their first value. */
    static List<Examination> examine(Model model) {
        return model.components().stream().flatMap(each -> examine(each).stream()).toList();
    }

    static List<Examination> examine(Component component) {
        Promise promise =
                component.isComposite()
                        ? Promise.required(component, arguments(component))
                        : Promise.of(component, arguments(component));
        return Analyses.examine(promise, List.of(), Budget.ofMemory());
    }

    static List<Value> arguments(Component component) {
        return component.parameters().stream().map(Models::constant).toList();
    }

    private static Value constant(Parameter parameter) {
        return parameter
                .initial()
                .map(initial -> ((Expression.Constant) initial).value())
                .orElseGet(() -> parameter.type().first());
    }
}
