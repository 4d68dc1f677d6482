package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.Typed;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Arguments for the parameters of a component. */
final class Arguments {
    private Arguments() {}

    /**
     * Adds the defaults of the parameters without an argument; where a default reads an earlier
     * parameter, its argument takes the place.
     *
     * @param environment of the component that declares the parameters
     */
    static List<Expression> complete(
            List<Expression> given,
            List<ParameterSymbol> symbols,
            List<Parameter> parameters,
            Environment environment) {
        List<Expression> all = new ArrayList<>(given);
        Map<String, Expression> byName = new HashMap<>();
        for (int i = 0; i < parameters.size(); i++) {
            Parameter parameter = parameters.get(i);
            if (i >= all.size()) {
                Typed initial = symbols.get(i).initial().orElseThrow();
                all.add(
                        new ExpressionLowering(environment.withArguments(byName))
                                .lower(initial, parameter.type()));
            }
            byName.put(parameter.name(), all.get(i));
        }
        return all;
    }
}
