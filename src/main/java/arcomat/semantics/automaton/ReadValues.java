package arcomat.semantics.automaton;

import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.ExpressionText;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Term;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** What an expression has read, in words: {@code distance is silent}, {@code left is 7}. */
record ReadValues(List<Read> reads) {
    /** A text or an object may be as long as somebody makes it. */
    private static final int LONGEST = 40;

    /**
     * Something that has a value: a port, a variable, a parameter, an attribute of an object.
     *
     * @param port that has to carry a message, if it is one
     */
    private record Read(String name, Term term, Optional<Port> port, boolean events) {
        /** Nothing where a port carries none. */
        Optional<Value> value(Value[] messages, Value[] variables) {
            return Optional.ofNullable(term.evaluate(messages, variables));
        }

        /** What has happened to a port that carries no message. */
        String silence() {
            String carrier = port.map(Port::name).orElse(name);
            if (!events) {
                return carrier + " is silent";
            }
            return port.filter(Port::latched).isPresent()
                    ? carrier + " has had no message yet"
                    : "the event is not on " + carrier;
        }

        String words(Value[] messages, Value[] variables) {
            return value(messages, variables)
                    .map(value -> name + " is " + shortened(value.toString()))
                    .orElseGet(this::silence);
        }
    }

    static ReadValues of(Expression expression, StepRelation relation) {
        Map<String, Read> reads = new LinkedHashMap<>();
        collect(expression, relation, reads);
        return new ReadValues(List.copyOf(reads.values()));
    }

    private static void collect(
            Expression expression, StepRelation relation, Map<String, Read> reads) {
        if (expression instanceof Expression.PortMatches matches) {
            collect(new Expression.PortRead(matches.port(), matches.span()), relation, reads);
        }
        if (isRead(expression)) {
            Read read = read(expression, relation);
            reads.putIfAbsent(read.name, read);
            return;
        }
        expression.operands().forEach(each -> collect(each, relation, reads));
    }

    /** Whether it is looked up only; what is computed is shown by what it is computed of. */
    private static boolean isRead(Expression expression) {
        return expression.match(
                new Expression.SomeCases<Boolean>() {
                    @Override
                    public Boolean portRead(Expression.PortRead read) {
                        return true;
                    }

                    @Override
                    public Boolean variableRead(Expression.VariableRead read) {
                        return true;
                    }

                    @Override
                    public Boolean parameterRead(Expression.ParameterRead read) {
                        return true;
                    }

                    @Override
                    public Boolean attributeRead(Expression.AttributeRead read) {
                        return isRead(read.object());
                    }

                    @Override
                    public Boolean otherwise(Expression any) {
                        return false;
                    }
                });
    }

    private static Read read(Expression expression, StepRelation relation) {
        return new Read(
                ExpressionText.of(expression),
                Evaluation.compile(expression, relation.scope()),
                expression.ports().stream().findFirst(),
                relation.component().profile() == Component.Profile.EVENT_DRIVEN);
    }

    /** Which of the ports carry no message. */
    String silent(Value[] messages, Value[] variables) {
        return reads.stream()
                .filter(each -> each.port.isPresent())
                .filter(each -> each.value(messages, variables).isEmpty())
                .map(Read::silence)
                .collect(Collectors.joining(", "));
    }

    /** All that was read; what reads nothing is as it is. */
    String values(Value[] messages, Value[] variables) {
        String words =
                reads.stream()
                        .map(each -> each.words(messages, variables))
                        .collect(Collectors.joining(", "));
        return words.isEmpty() ? "it is never true" : words;
    }

    private static String shortened(String text) {
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST - 3) + "...";
    }
}
