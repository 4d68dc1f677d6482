package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;

import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Puts what was sent in the place of the ports that receive it: what a part does is then said over
 * what the parts before it have read. Where nothing goes wrong in it, the value is the same.
 *
 * @param messages by the name of the port that receives; of all ports that an expression reads
 */
public record Delivery(Map<String, Message> messages) implements Expression.SomeCases<Expression> {
    private static final String NOWHERE = "nowhere ";

    /**
     * What is on a wire.
     *
     * @param present whether there is a message
     * @param value what it says, where there is one
     */
    public record Message(Expression present, Expression value) {
        public static final Message SILENCE = new Message(Formulas.FALSE, Formulas.FALSE);

        /** One that is there. */
        public static Message of(Expression value) {
            return new Message(Formulas.TRUE, value);
        }

        /** Whether it is known to be there. */
        public boolean isCertain() {
            return present.equals(Formulas.TRUE);
        }
    }

    public Delivery {
        messages = Map.copyOf(messages);
    }

    /** An expression that reads no variables and no parameters, with messages in it. */
    public Expression in(Expression expression) {
        return expression.rewritten(each -> each.match(this));
    }

    /**
     * Where there is no message, what reads it is not computed: conditions have tested that. Until
     * the test has been carried out, the read stands there with a name that no port has.
     */
    @Override
    public Expression portRead(Expression.PortRead read) {
        Port port = read.port();
        return message(port).equals(Message.SILENCE)
                ? new Expression.PortRead(port.named(NOWHERE + port.name()), read.span())
                : as(read.type(), message(port).value());
    }

    /** A message is of the type of its port, wherever it was computed. */
    private static Expression as(Type type, Expression value) {
        Optional<Type.Width> wanted = width(type);
        boolean fits = wanted.isEmpty() || wanted.equals(width(value.type()));
        return fits
                ? value
                : PartialEvaluation.folded(
                        new Expression.Cast(
                                value, Type.IntegerType.of(wanted.orElseThrow()), value.span()));
    }

    private static Optional<Type.Width> width(Type type) {
        return type instanceof Type.IntegerType integer
                ? Optional.of(integer.width())
                : Optional.empty();
    }

    @Override
    public Expression portMatches(Expression.PortMatches matches) {
        Message message = message(matches.port());
        return matches.pattern()
                .match(
                        oneOf ->
                                message.equals(Message.SILENCE)
                                        ? Formulas.FALSE
                                        : Formulas.and(message.present(), among(oneOf, matches)),
                        () -> Formulas.not(message.present()),
                        message::present);
    }

    private Expression among(Automaton.OneOf oneOf, Expression.PortMatches matches) {
        Port port = matches.port();
        Expression read = as(port.type(), message(port).value());
        return PartialEvaluation.among(read, oneOf, matches);
    }

    private Message message(Port port) {
        return Objects.requireNonNull(messages.get(port.name()), port.name());
    }

    @Override
    public Expression binary(Expression.Binary binary) {
        return Formulas.isLazy(binary) ? PartialEvaluation.connective(binary) : otherwise(binary);
    }

    @Override
    public Expression conditional(Expression.Conditional choice) {
        return PartialEvaluation.decided(choice);
    }

    @Override
    public Expression otherwise(Expression e) {
        return PartialEvaluation.folded(e);
    }
}
