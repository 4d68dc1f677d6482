package arcomat.analysis.automaton;

import arcomat.analysis.Budget;
import arcomat.analysis.Promise;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.FirstValue;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Models from text, and what the analyses say about them. */
final class Models {
    private Models() {}

    static Model read(List<SourceFile> files) {
        List<Unit> units = new ArrayList<>();
        for (SourceFile file : files) {
            Parsed parsed = Parser.parse(file);
            if (!parsed.findings().isEmpty()) {
                throw new AssertionError(parsed.findings().toString());
            }
            units.add(parsed.unit().orElseThrow());
        }
        return Lowering.lower(Workspace.of(units, Set.of()));
    }

    /** Of all components with automata; parameters without a default have their first value. */
    static List<Examination> examine(Model model) {
        return model.components().stream().flatMap(each -> examine(each).stream()).toList();
    }

    static List<Examination> examine(Component component) {
        Promise promise =
                component.isComposite()
                        ? Promise.required(component, arguments(component))
                        : Promise.of(component, arguments(component));
        return Analyses.examine(promise, Budget.ofMemory());
    }

    static List<Value> arguments(Component component) {
        return component.parameters().stream().map(Models::constant).toList();
    }

    private static Value constant(Parameter parameter) {
        return parameter
                .initial()
                .map(initial -> ((Expression.Constant) initial).value())
                .orElseGet(() -> FirstValue.of(parameter.type()));
    }
}
