package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * ARC0135: what stands for the parameters of an extended component stays small. Each component on
 * the way up may write a parameter several times, and what stands for it takes each of these
 * places.
 */
public final class SuperArgumentsSmall implements Check.OnComponent {
    /** In names, numbers and operators; what is larger takes long wherever it is computed. */
    private static final long LARGEST = 1_000;

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Signature heir = component.signature();
        if (heir.node().superArguments().isEmpty() || heir.isItsOwnAncestor()) {
            return;
        }
        Map<ParameterSymbol, Long> sizes = new HashMap<>();
        heir.lineage().forEach(each -> settle(each, sizes));
        if (sizes.values().stream().anyMatch(size -> size > LARGEST)) {
            findings.report(
                    heir.node().superComponent().orElseThrow().name(),
                    "what '%s' gives to '%s' grows on the way up to more than %s names and"
                            + " operators; give less, or write a parameter less often",
                    component.name(),
                    heir.node().superComponent().orElseThrow().name(),
                    LARGEST);
        }
    }

    private static void settle(Signature heir, Map<ParameterSymbol, Long> sizes) {
        if (heir.node().superArguments().isEmpty()) {
            return;
        }
        List<ParameterSymbol> above =
                heir.superComponent()
                        .flatMap(ComponentReference::component)
                        .map(Signature::parameters)
                        .orElse(List.of());
        for (ParameterSymbol parameter : above) {
            GivenArgument.find(heir.superArguments(), parameter)
                    .or(parameter::initial)
                    .ifPresent(
                            value ->
                                    sizes.put(
                                            parameter,
                                            value.size(part -> size(part, sizes), LARGEST + 1)));
        }
    }

    private static long size(TypedExpression part, Map<ParameterSymbol, Long> sizes) {
        return part instanceof TypedExpression.ParameterRead read
                ? sizes.getOrDefault(read.parameter(), 1L)
                : 1;
    }
}
