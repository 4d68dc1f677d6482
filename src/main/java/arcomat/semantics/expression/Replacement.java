package arcomat.semantics.expression;

import arcomat.model.Expression;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Puts expressions in the place of what is read, and computes what has a value then. What a
 * condition of {@link Guards} reads of a port that carries nothing does not matter, and stays.
 *
 * @param messages by the name of a port, empty for silence; other ports stay
 * @param variables by the name of a variable or constant; others stay
 * @param parameters by their names; others stay
 */
public record Replacement(
        Map<String, Optional<Expression>> messages,
        Map<String, Expression> variables,
        Map<String, Expression> parameters)
        implements Expression.SomeCases<Expression> {
    public Replacement {
        messages = Map.copyOf(messages);
        variables = Map.copyOf(variables);
        parameters = Map.copyOf(parameters);
    }

    /** Of messages only. */
    public static Replacement ofMessages(Map<String, Optional<Expression>> messages) {
        return new Replacement(messages, Map.of(), Map.of());
    }

    /** Of variables only. */
    public static Replacement ofVariables(Map<String, Expression> variables) {
        return new Replacement(Map.of(), variables, Map.of());
    }

    /** What an expression is then. What has been put into it stays as it is. */
    public Expression of(Expression expression) {
        return expression.rewritten(each -> each.match(this));
    }

    @Override
    public Expression portRead(Expression.PortRead read) {
        return Objects.requireNonNull(
                messages.getOrDefault(read.port().name(), Optional.empty()).orElse(read));
    }

    @Override
    public Expression variableRead(Expression.VariableRead read) {
        return Objects.requireNonNull(variables.getOrDefault(read.variable().name(), read));
    }

    @Override
    public Expression parameterRead(Expression.ParameterRead read) {
        return Objects.requireNonNull(parameters.getOrDefault(read.parameter().name(), read));
    }

    @Override
    public Expression portMatches(Expression.PortMatches matches) {
        Optional<Expression> message = messages.get(matches.port().name());
        if (message == null) {
            return matches;
        }
        Expression present = message.isPresent() ? Formulas.TRUE : Formulas.FALSE;
        return matches.pattern()
                .match(
                        oneOf ->
                                message.map(read -> PartialEvaluation.among(read, oneOf, matches))
                                        .orElse(Formulas.FALSE),
                        () -> Formulas.not(present),
                        () -> present);
    }

    @Override
    public Expression binary(Expression.Binary binary) {
        return Formulas.isLazy(binary)
                ? PartialEvaluation.connective(binary)
                : PartialEvaluation.folded(binary);
    }

    @Override
    public Expression conditional(Expression.Conditional choice) {
        return PartialEvaluation.decided(choice);
    }

    /** Operands have been computed already. */
    @Override
    public Expression otherwise(Expression e) {
        return PartialEvaluation.folded(e);
    }
}
