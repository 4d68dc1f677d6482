package arcomat.check.structure.component;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.names.TypeVariable;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * ARC0148: a parameter that is inherited and declared again keeps its type, which what is inherited
 * relies on. (Hab16 R14)
 */
public final class InheritedParameterUnchanged implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.node().superArguments().isPresent()) {
            return;
        }
        Map<String, ParameterSymbol> inherited = inherited(component);
        for (ParameterSymbol parameter : component.signature().ownParameters()) {
            ParameterSymbol old = inherited.get(parameter.name());
            if (old != null && isOther(parameter, old)) {
                findings.report(
                                parameter.nameSpan(),
                                "parameter '%s' is inherited as %s, but declared as %s; give this"
                                        + " one another name, or write arguments for '%s'",
                                parameter.name(),
                                Wording.distinct(old.type(), parameter.type()),
                                Wording.distinct(parameter.type(), old.type()),
                                component.node().superComponent().orElseThrow().name())
                        .related(old.nameSpan(), "the inherited parameter");
            }
        }
    }

    /** The nearest of each name; none from beyond where arguments settle all of them. */
    private static Map<String, ParameterSymbol> inherited(ComponentSymbol component) {
        Map<String, ParameterSymbol> inherited = new HashMap<>();
        List<ComponentSymbol> line = component.lineage();
        for (ComponentSymbol ancestor : line.subList(1, line.size())) {
            ancestor.signature()
                    .ownParameters()
                    .forEach(each -> inherited.putIfAbsent(each.name(), each));
            if (ancestor.node().superArguments().isPresent()) {
                break;
            }
        }
        return inherited;
    }

    /** What a type parameter stands for is not asked: that of an ancestor has its own name. */
    private static boolean isOther(ParameterSymbol parameter, ParameterSymbol old) {
        return !parameter.type().isErroneous()
                && !old.type().isErroneous()
                && !(old.type() instanceof TypeVariable)
                && !parameter.type().equals(old.type());
    }
}
