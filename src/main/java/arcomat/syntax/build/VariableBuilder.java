package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.ValuedVariableContext;
import arcomat.syntax.antlr.ArcomatParser.VariableContext;
import arcomat.tree.Variable;

/** Declared variables. */
final class VariableBuilder extends TreeBuilder<Variable> {
    VariableBuilder(Builders builders) {
        super(builders);
    }

    @Override
    public Variable visitVariable(VariableContext context) {
        return new Variable(
                span(context),
                builders.names.build(context.name()),
                builders.expressions.buildOptional(context.expression()));
    }

    @Override
    public Variable visitValuedVariable(ValuedVariableContext context) {
        return new Variable(
                span(context),
                builders.names.build(context.name()),
                builders.expressions.buildOptional(context.expression()));
    }
}
