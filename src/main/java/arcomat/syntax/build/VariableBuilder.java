package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.ValuedVariableContext;
import arcomat.syntax.antlr.ArcomatParser.VariableContext;
import arcomat.tree.Variable;

/** Declared variables. */
final class VariableBuilder extends TreeBuilder<Variable> {
    private final NameBuilder names;
    private final ExpressionBuilder expressions;

    VariableBuilder(SharedTexts texts, NameBuilder names, ExpressionBuilder expressions) {
        super(texts);
        this.names = names;
        this.expressions = expressions;
    }

    @Override
    public Variable visitVariable(VariableContext context) {
        return new Variable(
                span(context),
                names.build(context.name()),
                expressions.buildOptional(context.expression()));
    }

    @Override
    public Variable visitValuedVariable(ValuedVariableContext context) {
        return new Variable(
                span(context),
                names.build(context.name()),
                expressions.buildOptional(context.expression()));
    }
}
