package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeSymbol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What the names in one component mean in the model.
 *
 * @param arguments values that stand for parameters; parameters without one stay parameters
 */
record Environment(
        TypeSubstitution types,
        Map<String, Port> ports,
        Map<String, Parameter> parameters,
        Map<String, Expression> arguments,
        Map<String, Variable> constants,
        Map<String, Variable> variables) {

    static Environment of(TypeSubstitution types) {
        return new Environment(types, Map.of(), Map.of(), Map.of(), Map.of(), Map.of());
    }

    Type type(TypeSymbol symbol) {
        return TypeLowering.lower(types.apply(symbol));
    }

    Environment withPorts(List<Port> more) {
        Map<String, Port> all = new HashMap<>(ports);
        more.forEach(port -> all.put(port.name(), port));
        return new Environment(types, all, parameters, arguments, constants, variables);
    }

    Environment withParameters(List<Parameter> more) {
        Map<String, Parameter> all = new HashMap<>(parameters);
        more.forEach(parameter -> all.put(parameter.name(), parameter));
        return new Environment(types, ports, all, arguments, constants, variables);
    }

    Environment withArguments(Map<String, Expression> values) {
        return new Environment(types, ports, parameters, Map.copyOf(values), constants, variables);
    }

    Environment withConstants(List<Variable> more) {
        Map<String, Variable> all = new HashMap<>(constants);
        more.forEach(constant -> all.put(constant.name(), constant));
        return new Environment(types, ports, parameters, arguments, all, variables);
    }

    Environment withVariables(List<Variable> more) {
        Map<String, Variable> all = new HashMap<>(variables);
        more.forEach(variable -> all.put(variable.name(), variable));
        return new Environment(types, ports, parameters, arguments, constants, all);
    }
}
