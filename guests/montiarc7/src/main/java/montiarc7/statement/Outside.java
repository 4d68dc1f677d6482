package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.AssignStatementContext;
import montiarc7.grammar.MontiArc7Parser.CallExpressionContext;
import montiarc7.grammar.MontiArc7Parser.CallStatementContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.LocalStatementContext;
import montiarc7.grammar.MontiArc7Parser.MemberExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NewExpressionContext;
import montiarc7.grammar.MontiArc7Parser.StatementContext;
import montiarc7.grammar.MontiArc7Parser.VariableContext;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.HashSet;
import java.util.Set;

/**
 * What an action does with objects, where no port and no variable of the component depends on it:
 * methods of classes that are called as statements, and local variables that hold objects, or what
 * was found in one, of which nothing that is converted reads anything.
 */
final class Outside {
    private final Scope scope;

    /** Local variables that are left out with all that is done with them. */
    private final Set<String> unseen;

    private Outside(Scope scope, Set<String> unseen) {
        this.scope = scope;
        this.unseen = Set.copyOf(unseen);
    }

    static Outside of(ParserRuleContext action, Scope scope) {
        Set<String> objects = new HashSet<>();
        collect(action, scope, objects);
        Outside outside = new Outside(scope, objects);
        Set<String> read = outside.read(action);
        while (objects.removeAll(read)) {
            outside = new Outside(scope, objects);
            read = outside.read(action);
        }
        return outside;
    }

    /** Local variables with values that Arcomat cannot say. */
    private static void collect(ParserRuleContext tree, Scope scope, Set<String> objects) {
        if (tree instanceof VariableContext variable
                && tree.getParent() instanceof LocalStatementContext
                && variable.expression() != null
                && !scope.isDeclared(variable.name().getText())
                && !canBeSaid(variable.expression(), scope)) {
            objects.add(variable.name().getText());
        }
        for (var child : tree.children) {
            if (child instanceof ParserRuleContext inner && inner.children != null) {
                collect(inner, scope, objects);
            }
        }
    }

    private static boolean canBeSaid(ExpressionContext value, Scope scope) {
        Scope unheard = scope.unheard();
        new ExpressionWriter(unheard).write(value);
        return !unheard.lacks().isAny();
    }

    /** Names that are read by what is not left out. */
    private Set<String> read(ParserRuleContext tree) {
        Set<String> names = new HashSet<>();
        if (tree instanceof StatementContext statement && isLeftOut(statement)) {
            return names;
        }
        if (tree instanceof ExpressionContext expression) {
            return Names.in(expression);
        }
        for (var child : tree.children) {
            if (child instanceof ParserRuleContext inner && inner.children != null) {
                names.addAll(read(inner));
            }
        }
        return names;
    }

    boolean isLeftOut(StatementContext statement) {
        if (statement instanceof CallStatementContext call) {
            return call.expression() instanceof CallExpressionContext made
                    && made.expression(0) instanceof MemberExpressionContext method
                    && isOutside(method.expression());
        } else if (statement instanceof AssignStatementContext assign) {
            return unseen.contains(assign.expression(0).getText())
                    || assign.expression(0) instanceof MemberExpressionContext attribute
                            && isOutside(attribute.expression());
        }
        return statement instanceof LocalStatementContext local
                && local.variable().stream()
                        .allMatch(each -> unseen.contains(each.name().getText()));
    }

    /** Whether it is a class, an object that was just made, or one that nobody sees. */
    private boolean isOutside(ExpressionContext owner) {
        if (owner instanceof NameExpressionContext name) {
            return unseen.contains(name.getText())
                    || isCapital(name.getText()) && !scope.isDeclared(name.getText());
        } else if (owner instanceof MemberExpressionContext member) {
            return scope.types().isType(member.getText()) || isOutside(member.expression());
        } else if (owner instanceof CallExpressionContext made) {
            return isConstructor(made.expression(0));
        }
        return owner instanceof NewExpressionContext;
    }

    private static boolean isCapital(String name) {
        return Character.isUpperCase(name.codePointAt(0));
    }

    /** A class, and its name again. */
    private static boolean isConstructor(ExpressionContext called) {
        return called instanceof MemberExpressionContext member
                && isCapital(member.name().getText())
                && ("." + member.expression().getText()).endsWith("." + member.name().getText());
    }
}
