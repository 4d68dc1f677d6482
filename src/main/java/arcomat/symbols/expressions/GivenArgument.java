package arcomat.symbols.expressions;

import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Argument;
import arcomat.tree.Expression;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;

/**
 * An argument, and the parameter that it is for: the one that it names; without a name, that at the
 * same place.
 *
 * @param parameter empty where there is none of that name or at that place
 */
public record GivenArgument(Argument node, Optional<ParameterSymbol> parameter, Typed value) {

    /**
     * The arguments of one list.
     *
     * @param seen from types of parameters to those that the arguments meet
     * @param typing types an expression for a type
     */
    public static List<GivenArgument> of(
            List<Argument> written,
            List<ParameterSymbol> parameters,
            UnaryOperator<TypeSymbol> seen,
            BiFunction<Expression, TypeSymbol, Typed> typing) {
        List<GivenArgument> given = new ArrayList<>();
        for (Argument node : written) {
            Optional<ParameterSymbol> parameter =
                    node.name().isPresent()
                            ? named(node.name().get().text(), parameters)
                            : at(given.size(), parameters);
            TypeSymbol expected =
                    parameter.map(ParameterSymbol::type).map(seen).orElse(UnknownType.UNKNOWN);
            given.add(new GivenArgument(node, parameter, typing.apply(node.value(), expected)));
        }
        return List.copyOf(given);
    }

    private static Optional<ParameterSymbol> named(String name, List<ParameterSymbol> parameters) {
        return parameters.stream().filter(each -> each.name().equals(name)).findFirst();
    }

    private static Optional<ParameterSymbol> at(int place, List<ParameterSymbol> parameters) {
        return place < parameters.size() ? Optional.of(parameters.get(place)) : Optional.empty();
    }

    /** The value that a list has for a parameter; of two the first. */
    public static Optional<Typed> find(List<GivenArgument> given, ParameterSymbol parameter) {
        return given.stream()
                .filter(each -> each.isFor(parameter))
                .map(GivenArgument::value)
                .findFirst();
    }

    public boolean isFor(ParameterSymbol wanted) {
        return parameter.filter(each -> each == wanted).isPresent();
    }

    /** Whether it names a parameter that there is not. */
    public boolean isLost() {
        return node.name().isPresent() && parameter.isEmpty();
    }
}
