package arcomat.lower;

import arcomat.model.Expression;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.signatures.Signature;

import java.util.List;

/**
 * What components give to the parameters of those that they extend: {@code component Fast extends
 * Motor(3)}. In all that Fast inherits, 3 stands for the parameter.
 */
final class SuperArguments {
    private SuperArguments() {}

    /**
     * @param environment with the parameters that the component has itself
     */
    static Environment settle(ComponentSymbol component, Environment environment) {
        Environment current = environment;
        for (Signature heir : component.signature().lineage()) {
            if (heir.node().superArguments().isPresent()) {
                current = settle(heir, current);
            }
        }
        return current;
    }

    /** Defaults may read the parameters before them. */
    private static Environment settle(Signature heir, Environment environment) {
        Environment current = environment;
        for (ParameterSymbol parameter : above(heir)) {
            Typed value =
                    GivenArgument.find(heir.superArguments(), parameter)
                            .or(parameter::initial)
                            .orElseThrow();
            Expression lowered =
                    new ExpressionLowering(current).lower(value, current.type(parameter.type()));
            current = current.withSettled(parameter, lowered);
        }
        return current;
    }

    private static List<ParameterSymbol> above(Signature heir) {
        return Lowering.resolved(heir.superComponent().orElseThrow().resolution(), heir)
                .parameters();
    }
}
