package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.Typed;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Arguments for the parameters of a component. */
final class ArgumentLowering {
    private ArgumentLowering() {}

    /**
     * The arguments as written, and the defaults of the parameters without one; where a default
     * reads an earlier parameter, its argument takes the place.
     *
     * @param user what names mean where the arguments are written
     * @param declaring what they mean in the component that declares the parameters
     */
    static List<Expression> lower(
            List<GivenArgument> written,
            Environment user,
            List<ParameterSymbol> symbols,
            List<Parameter> parameters,
            Environment declaring) {
        List<Expression> all = new ArrayList<>();
        Map<String, Expression> byName = new HashMap<>();
        for (int i = 0; i < parameters.size(); i++) {
            Parameter parameter = parameters.get(i);
            ParameterSymbol symbol = symbols.get(i);
            Optional<Typed> given = GivenArgument.find(written, symbol);
            Typed value = given.or(symbol::initial).orElseThrow();
            Environment names = given.isPresent() ? user : declaring.withArguments(byName);
            all.add(new ExpressionLowering(names).lower(value, parameter.type()));
            byName.put(parameter.name(), all.get(i));
        }
        return all;
    }
}
