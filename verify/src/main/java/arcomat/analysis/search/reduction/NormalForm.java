package arcomat.analysis.search.reduction;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/**
 * Automata and what they are made of as text that is the same for what means the same: operands of
 * {@code &&} and {@code ||} stand in the order of the alphabet, and places in models do not count.
 * Who compares such texts has to make sure that nothing divides by zero: which operand is looked at
 * first would matter.
 *
 * @param inputs what an input port is called
 */
record NormalForm(UnaryOperator<String> inputs) implements Expression.Cases<String> {

    /** All that an automaton does. */
    String of(Automaton automaton) {
        return joined(
                automaton.completion(),
                automaton.omitted(),
                automaton.states().size(),
                automaton.variables().stream()
                        .map(v -> joined(v.name(), v.type(), of(v.initial())))
                        .toList(),
                sorted(automaton.initials().stream().map(this::of).toList()),
                sorted(automaton.transitions().stream().map(this::of).toList()));
    }

    private String of(Automaton.Initial initial) {
        return joined(initial.state(), sends(initial.sends()), assigned(initial.assignments()));
    }

    private String of(Automaton.Transition transition) {
        return joined(transition.source(), transition.target(), label(transition));
    }

    /** A transition, whatever its states. */
    String label(Automaton.Transition transition) {
        return joined(
                transition.rank(),
                transition.guard().map(this::of).orElse(""),
                sorted(transition.matches().stream().map(this::of).toList()),
                sends(transition.sends()),
                assigned(transition.assignments()));
    }

    private String of(Automaton.Match match) {
        return joined(inputs.apply(match.port().name()), of(match.pattern()));
    }

    private String of(Automaton.Pattern pattern) {
        return pattern.match(
                oneOf -> "one of " + sorted(all(oneOf.values())), () -> "--", () -> "?");
    }

    private List<String> sends(List<Automaton.Send> sends) {
        return sorted(sends.stream().map(s -> joined(s.port().name(), of(s.emission()))).toList());
    }

    private String of(Automaton.Emission emission) {
        return emission.match(
                messages -> "all of " + all(messages.values()), () -> "--", () -> "?");
    }

    private List<String> assigned(List<Automaton.Assignment> assignments) {
        return sorted(
                assignments.stream().map(a -> joined(a.variable().name(), of(a.value()))).toList());
    }

    String of(Expression e) {
        return e.match(this);
    }

    private List<String> all(List<Expression> expressions) {
        return expressions.stream().map(this::of).toList();
    }

    private static List<String> sorted(List<String> texts) {
        return texts.stream().sorted().toList();
    }

    /** Each with its length, so that no text is part of another one. */
    private static String joined(Object... items) {
        List<String> texts = new ArrayList<>();
        for (Object item : items) {
            String text = String.valueOf(item);
            texts.add(text.length() + ":" + text);
        }
        return texts.stream().collect(Collectors.joining(" ", "(", ")"));
    }

    private String port(Port port) {
        return inputs.apply(port.name());
    }

    @Override
    public String constant(Expression.Constant constant) {
        return joined("constant", constant.type(), constant.value());
    }

    @Override
    public String portRead(Expression.PortRead read) {
        return joined("port", port(read.port()));
    }

    @Override
    public String variableRead(Expression.VariableRead read) {
        return joined("variable", read.variable().name());
    }

    @Override
    public String parameterRead(Expression.ParameterRead read) {
        return joined("parameter", read.parameter().name());
    }

    @Override
    public String attributeRead(Expression.AttributeRead read) {
        return joined("attribute", read.index(), of(read.object()));
    }

    @Override
    public String portMatches(Expression.PortMatches matches) {
        return joined("matches", port(matches.port()), of(matches.pattern()));
    }

    @Override
    public String unary(Expression.Unary unary) {
        return joined(unary.operator(), unary.type(), of(unary.operand()));
    }

    @Override
    public String binary(Expression.Binary binary) {
        BinaryOperator operator = binary.operator();
        if (operator != BinaryOperator.AND && operator != BinaryOperator.OR) {
            return joined(operator, binary.type(), of(binary.left()), of(binary.right()));
        }
        List<String> operands = new ArrayList<>();
        addOperands(operator, binary, operands);
        return joined(operator, sorted(operands));
    }

    private void addOperands(BinaryOperator operator, Expression e, List<String> operands) {
        if (e instanceof Expression.Binary binary && binary.operator() == operator) {
            addOperands(operator, binary.left(), operands);
            addOperands(operator, binary.right(), operands);
        } else {
            operands.add(of(e));
        }
    }

    @Override
    public String conditional(Expression.Conditional choice) {
        return joined("if", of(choice.condition()), of(choice.then()), of(choice.otherwise()));
    }

    @Override
    public String isIn(Expression.IsIn isIn) {
        return joined("in", of(isIn.element()), sorted(all(isIn.set())));
    }

    /** No model is written with one. */
    @Override
    public String judged(Expression.Judged judged) {
        throw new AssertionError(judged);
    }

    @Override
    public String cast(Expression.Cast cast) {
        return joined("cast", cast.type(), of(cast.operand()));
    }
}
