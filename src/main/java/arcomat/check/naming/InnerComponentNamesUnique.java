package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.HashMap;
import java.util.Map;

/** ARC0215: the components declared inside one component differ in name. */
public final class InnerComponentNamesUnique implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0215");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<String, ComponentSymbol> seen = new HashMap<>();
        for (ComponentSymbol inner : component.innerComponents()) {
            ComponentSymbol first = seen.putIfAbsent(inner.name(), inner);
            if (first != null) {
                findings.report(
                                inner.nameSpan(),
                                "component '"
                                        + component.name()
                                        + "' declares an inner component '"
                                        + inner.name()
                                        + "' already; rename one, or use it for both parts")
                        .related(first.nameSpan(), "the first one");
            }
        }
    }
}
