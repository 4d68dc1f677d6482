package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeSymbol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * What the names in one component mean in the model.
 *
 * @param arguments values that stand for parameters; parameters without one stay parameters
 * @param settled what an heir gives to parameters of components that it extends; its own may be
 *     called the same
 */
record Environment(
        TypeSubstitution types,
        Map<String, Port> ports,
        Map<String, Parameter> parameters,
        Map<String, Expression> arguments,
        Map<ParameterSymbol, Expression> settled,
        Map<String, Variable> constants,
        Map<String, Variable> variables) {

    static Environment of(TypeSubstitution types) {
        return new Environment(types, Map.of(), Map.of(), Map.of(), Map.of(), Map.of(), Map.of());
    }

    Type type(TypeSymbol symbol) {
        return TypeLowering.lower(types.apply(symbol));
    }

    Environment withPorts(List<Port> more) {
        Map<String, Port> all = with(ports, more, Port::name);
        return new Environment(types, all, parameters, arguments, settled, constants, variables);
    }

    Environment withParameters(List<Parameter> more) {
        Map<String, Parameter> all = with(parameters, more, Parameter::name);
        return new Environment(types, ports, all, arguments, settled, constants, variables);
    }

    Environment withArguments(Map<String, Expression> values) {
        return new Environment(
                types, ports, parameters, Map.copyOf(values), settled, constants, variables);
    }

    Environment withSettled(ParameterSymbol parameter, Expression value) {
        Map<ParameterSymbol, Expression> all = new HashMap<>(settled);
        all.put(parameter, value);
        return new Environment(types, ports, parameters, arguments, all, constants, variables);
    }

    Environment withConstants(List<Variable> more) {
        Map<String, Variable> all = with(constants, more, Variable::name);
        return new Environment(types, ports, parameters, arguments, settled, all, variables);
    }

    Environment withVariables(List<Variable> more) {
        Map<String, Variable> all = with(variables, more, Variable::name);
        return new Environment(types, ports, parameters, arguments, settled, constants, all);
    }

    private static <T> Map<String, T> with(
            Map<String, T> known, List<T> more, Function<T, String> name) {
        Map<String, T> all = new HashMap<>(known);
        more.forEach(each -> all.put(name.apply(each), each));
        return all;
    }
}
