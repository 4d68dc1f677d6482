package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Confirmation;
import arcomat.analysis.automaton.exploration.Stepper;
import arcomat.analysis.bits.BitLogic;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.StateFacts;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.SymbolicSearch;
import arcomat.analysis.search.Budget;
import arcomat.analysis.smt.LinearLogic;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.semantics.Promise;

import java.util.Collection;
import java.util.List;
import java.util.Map;

/** What the analyses say about models. */
final class Models {
    static final List<Logic.Kind<?>> SOLVERS = List.of(LinearLogic.KIND, BitLogic.KIND);

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

    /** What solvers answer, one after the other; runs count that the automaton agrees with. */
    static Map<RunProperty, Reachability> answers(
            Subject subject, Collection<RunProperty> asked, List<Logic.Kind<?>> solvers) {
        Confirmation confirmation = new Confirmation(subject, Stepper.of(subject));
        return SymbolicSearch.answer(
                subject,
                asked,
                solvers,
                StateFacts.NONE,
                (question, run) -> confirmation.of(question, run).isPresent(),
                () -> false);
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
