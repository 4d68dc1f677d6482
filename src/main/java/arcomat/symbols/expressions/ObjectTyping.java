package arcomat.symbols.expressions;

import arcomat.symbols.names.ClassSymbol;
import arcomat.tree.Expression;

import java.util.List;

/** Objects written out in stream tests: one value per attribute, inherited ones first. */
final class ObjectTyping {
    private ObjectTyping() {}

    static TypedExpression type(
            Expression.Call call,
            ClassSymbol type,
            List<TypedExpression> arguments,
            ProblemSink problems) {
        List<ClassSymbol.AttributeSymbol> attributes = type.attributes();
        if (arguments.size() != attributes.size()) {
            problems.report(
                    ExpressionProblem.Kind.OPERAND_TYPE,
                    call,
                    type.text()
                            + " has "
                            + Texts.count(attributes.size(), "attribute")
                            + ", but "
                            + Texts.count(arguments.size(), "value")
                            + (arguments.size() == 1 ? " is" : " are")
                            + " given; write one value per attribute");
            return new TypedExpression.Erroneous(call, arguments);
        }
        for (int i = 0; i < arguments.size(); i++) {
            ClassSymbol.AttributeSymbol attribute = attributes.get(i);
            if (!TypeRules.isAssignable(arguments.get(i), attribute.type())) {
                problems.report(
                        ExpressionProblem.Kind.OPERAND_TYPE,
                        arguments.get(i).node(),
                        "attribute '"
                                + attribute.name()
                                + "' has type "
                                + attribute.type().text()
                                + ", not "
                                + arguments.get(i).type().text());
            }
        }
        return new TypedExpression.NewObject(call, type, arguments);
    }
}
