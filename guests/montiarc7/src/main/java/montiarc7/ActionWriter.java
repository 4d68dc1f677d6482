package montiarc7;

import montiarc7.MontiArc7Parser.AssignStatementContext;
import montiarc7.MontiArc7Parser.BlockContext;
import montiarc7.MontiArc7Parser.BlockStatementContext;
import montiarc7.MontiArc7Parser.CallExpressionContext;
import montiarc7.MontiArc7Parser.CallStatementContext;
import montiarc7.MontiArc7Parser.EmptyStatementContext;
import montiarc7.MontiArc7Parser.ExpressionContext;
import montiarc7.MontiArc7Parser.IfStatementContext;
import montiarc7.MontiArc7Parser.LocalStatementContext;
import montiarc7.MontiArc7Parser.MemberExpressionContext;
import montiarc7.MontiArc7Parser.NameExpressionContext;
import montiarc7.MontiArc7Parser.StatementContext;
import montiarc7.MontiArc7Parser.StepStatementContext;
import montiarc7.MontiArc7Parser.SwitchCaseContext;
import montiarc7.MontiArc7Parser.SwitchStatementContext;
import montiarc7.MontiArc7Parser.VariableContext;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Actions as statements behind 'do', which are sequential there as they are in MontiArc. */
final class ActionWriter {
    private final Scope scope;
    private final ExpressionWriter expressions;
    private final Guards guards;

    ActionWriter(Scope scope) {
        this.scope = scope;
        this.expressions = new ExpressionWriter(scope);
        this.guards = new Guards(expressions);
    }

    /** What is done one after the other; empty where nothing is. */
    String write(List<? extends ParserRuleContext> actions) {
        StringBuilder text = new StringBuilder();
        Map<String, Integer> sent = new HashMap<>();
        for (ParserRuleContext action : actions) {
            String written = inside(action);
            text.append(hasLocals(action) && actions.size() > 1 ? "{" + written + "}" : written);
            sends(action).forEach((port, count) -> sent.merge(port, count, Integer::sum));
        }
        sent.forEach(
                (port, count) -> {
                    if (count > 1) {
                        scope.lacks()
                                .missing(
                                        Lack.SENT_TWICE,
                                        actions.get(0),
                                        "'%s' is sent more than once in one step; a port of Arcomat carries one message in a slice"
                                                .formatted(port));
                    }
                });
        return text.toString();
    }

    /** Names that are declared in one action are not known in the next one. */
    private static boolean hasLocals(ParserRuleContext action) {
        BlockContext block =
                action instanceof BlockStatementContext statement
                        ? statement.block()
                        : action instanceof BlockContext plain ? plain : null;
        return block != null
                && block.statement().stream().anyMatch(LocalStatementContext.class::isInstance);
    }

    /** The same without braces around the whole. */
    String inside(ParserRuleContext action) {
        if (action instanceof BlockStatementContext block) {
            return inside(block.block());
        }
        if (action instanceof BlockContext block) {
            StringBuilder text = new StringBuilder();
            block.statement().forEach(each -> text.append(statement(each)));
            return text.toString();
        }
        return statement((StatementContext) action);
    }

    private String statement(StatementContext statement) {
        if (statement instanceof BlockStatementContext block) {
            return "{" + inside(block.block()) + "}\n";
        } else if (statement instanceof EmptyStatementContext) {
            return "";
        } else if (statement instanceof IfStatementContext choice) {
            return choice(choice);
        } else if (statement instanceof SwitchStatementContext choice) {
            return new SwitchWriter(scope).write(choice);
        } else if (statement instanceof AssignStatementContext assign) {
            return assign(assign);
        } else if (statement instanceof StepStatementContext step) {
            String name = target(step.expression());
            return name + step.step.getText() + ";\n";
        } else if (statement instanceof LocalStatementContext local) {
            StringBuilder text = new StringBuilder(scope.types().message(local.type()) + " ");
            for (VariableContext each : local.variable()) {
                text.append(each == local.variable(0) ? "" : ", ").append(each.name().getText());
                if (each.expression() != null) {
                    text.append(" = ").append(expressions.write(each.expression()));
                }
            }
            return text.append(";\n").toString();
        } else if (statement instanceof CallStatementContext call && isOutside(call.expression())) {
            scope.lacks()
                    .note(
                            Lack.OUTSIDE,
                            statement,
                            "this call is left out: what it does is done outside of the model");
            return "";
        }
        String what = statement instanceof CallStatementContext ? "call" : "statement";
        scope.lacks()
                .missing(
                        Lack.STATEMENT,
                        statement,
                        "this %s cannot be said in Arcomat, whose actions have assignments, local variables and 'if'"
                                .formatted(what));
        return "";
    }

    /** Whether a method of a class is called, and not one of an object that the model holds. */
    private static boolean isOutside(ExpressionContext call) {
        return call instanceof CallExpressionContext made
                && made.expression(0) instanceof MemberExpressionContext member
                && root(member) instanceof NameExpressionContext name
                && Character.isUpperCase(name.getText().codePointAt(0));
    }

    private static ExpressionContext root(MemberExpressionContext member) {
        ExpressionContext at = member;
        while (at instanceof MemberExpressionContext inner) {
            at = inner.expression();
        }
        return at;
    }

    private String choice(IfStatementContext choice) {
        Set<String> present = guards.presentIn(choice.expression());
        ActionWriter then = new ActionWriter(scope.with(present));
        StringBuilder text = new StringBuilder("if (");
        text.append(expressions.write(choice.expression())).append(") {");
        text.append(then.inside(choice.statement(0))).append("}");
        if (choice.statement().size() > 1) {
            text.append(" else {").append(inside(choice.statement(1))).append("}");
        }
        return text.append("\n").toString();
    }

    private String assign(AssignStatementContext assign) {
        String name = target(assign.expression(0));
        ExpressionContext value = assign.expression(1);
        String operator = assign.assign.getText();
        String written = expressions.write(value);
        if (operator.matches("[*/%]=")) {
            return "%s = %s %s (%s);%n".formatted(name, name, operator.substring(0, 1), written);
        }
        // What is only passed on is passed on as silence, too.
        if (value instanceof NameExpressionContext port
                && scope.outputs().contains(name)
                && scope.inputs().contains(port.getText())
                && !scope.present().contains(port.getText())) {
            return "if (%s != --) {%s = %s;}%n".formatted(port.getText(), name, port.getText());
        }
        return name + " " + operator + " " + written + ";\n";
    }

    private String target(ExpressionContext expression) {
        String name = expression.getText().replaceFirst("^this\\.", "");
        if (!name.matches("[\\p{L}_$][\\p{L}\\p{N}_$]*") || scope.inputs().contains(name)) {
            scope.lacks()
                    .missing(
                            Lack.STATEMENT,
                            expression,
                            "nothing can be assigned to '%s' in Arcomat"
                                    .formatted(expression.getText()));
        }
        return name;
    }

    /**
     * Choices about inputs of which at most one is made, which actions between them cannot change.
     */
    private boolean isApart(StatementContext statement, List<IfStatementContext> others) {
        return statement instanceof IfStatementContext choice
                && choice.statement().size() == 1
                && isOfInputs(choice.expression())
                && others.stream()
                        .allMatch(each -> guards.exclude(each.expression(), choice.expression()));
    }

    private boolean isOfInputs(ExpressionContext expression) {
        if (expression instanceof MemberExpressionContext member) {
            return expressions.isConstant(member);
        }
        if (expression instanceof NameExpressionContext name) {
            return scope.inputs().contains(name.getText());
        }
        return expression.children.stream()
                .filter(ExpressionContext.class::isInstance)
                .allMatch(each -> isOfInputs((ExpressionContext) each));
    }

    /** How often each output port is sent at most. */
    Map<String, Integer> sends(ParserRuleContext action) {
        Map<String, Integer> all = new HashMap<>();
        if (action instanceof BlockStatementContext block) {
            return sends(block.block());
        } else if (action instanceof BlockContext block) {
            List<IfStatementContext> apart = new ArrayList<>();
            Map<String, Integer> most = new HashMap<>();
            for (StatementContext each : block.statement()) {
                if (isApart(each, apart)) {
                    apart.add((IfStatementContext) each);
                    sends(each).forEach((port, count) -> most.merge(port, count, Integer::max));
                } else {
                    sends(each).forEach((port, count) -> all.merge(port, count, Integer::sum));
                }
            }
            most.forEach((port, count) -> all.merge(port, count, Integer::sum));
        } else if (action instanceof IfStatementContext choice) {
            for (StatementContext each : choice.statement()) {
                sends(each).forEach((port, count) -> all.merge(port, count, Integer::max));
            }
        } else if (action instanceof SwitchStatementContext choice) {
            for (SwitchCaseContext each : choice.switchCase()) {
                Map<String, Integer> here = new HashMap<>();
                each.statement()
                        .forEach(
                                one ->
                                        sends(one)
                                                .forEach(
                                                        (port, count) ->
                                                                here.merge(
                                                                        port,
                                                                        count,
                                                                        Integer::sum)));
                here.forEach((port, count) -> all.merge(port, count, Integer::max));
            }
        } else if (action instanceof AssignStatementContext assign) {
            String name = assign.expression(0).getText();
            if (scope.outputs().contains(name)) {
                all.put(name, 1);
            }
        }
        return all;
    }

    /** The names that something is assigned to, but for ports. */
    Set<String> assigned(ParserRuleContext action) {
        Set<String> names = new HashSet<>();
        if (action instanceof AssignStatementContext assign) {
            names.add(assign.expression(0).getText());
        } else if (action instanceof StepStatementContext step) {
            names.add(step.expression().getText());
        } else if (action.children != null) {
            for (var child : action.children) {
                if (child instanceof ParserRuleContext inner) {
                    names.addAll(assigned(inner));
                }
            }
        }
        names.removeAll(scope.outputs());
        return names;
    }
}
