package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.symbols.expressions.VariableSymbol;

import java.util.ArrayList;
import java.util.List;

/** Variables and constants with their initial values. */
final class VariableLowering {
    private VariableLowering() {}

    /** Each may read the constants before it in the list, as far as its scope let it. */
    static List<Variable> lower(List<VariableSymbol> symbols, Environment environment) {
        List<Variable> variables = new ArrayList<>();
        Environment current = environment;
        for (VariableSymbol symbol : symbols) {
            Variable variable = lower(symbol, current);
            variables.add(variable);
            // A field counts as a constant here: a law lets nobody read it so early.
            if (symbol.kind() == VariableSymbol.Kind.COMPONENT) {
                current = current.withConstants(List.of(variable));
            }
        }
        return List.copyOf(variables);
    }

    private static Variable lower(VariableSymbol symbol, Environment environment) {
        Type type = environment.type(symbol.type());
        Expression initial =
                symbol.initial()
                        .map(i -> new ExpressionLowering(environment).lower(i, type))
                        .orElseGet(
                                () ->
                                        new Expression.Constant(
                                                type.first(),
                                                Conversion.carrier(type),
                                                symbol.nameSpan()));
        return new Variable(symbol.name(), type, initial, symbol.nameSpan());
    }
}
