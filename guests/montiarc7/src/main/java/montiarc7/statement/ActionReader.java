package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.AssignStatementContext;
import montiarc7.grammar.MontiArc7Parser.AssignStepStatementContext;
import montiarc7.grammar.MontiArc7Parser.BlockContext;
import montiarc7.grammar.MontiArc7Parser.BlockStatementContext;
import montiarc7.grammar.MontiArc7Parser.BreakStatementContext;
import montiarc7.grammar.MontiArc7Parser.CallStatementContext;
import montiarc7.grammar.MontiArc7Parser.ContinueStatementContext;
import montiarc7.grammar.MontiArc7Parser.EmptyStatementContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.IfStatementContext;
import montiarc7.grammar.MontiArc7Parser.LocalStatementContext;
import montiarc7.grammar.MontiArc7Parser.MemberExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.grammar.MontiArc7Parser.StatementContext;
import montiarc7.grammar.MontiArc7Parser.StepStatementContext;
import montiarc7.grammar.MontiArc7Parser.SwitchStatementContext;
import montiarc7.grammar.MontiArc7Parser.TypeContext;
import montiarc7.grammar.MontiArc7Parser.VariableContext;
import montiarc7.source.Lack;
import montiarc7.statement.Course.Next;
import montiarc7.statement.Deed.Block;
import montiarc7.statement.Deed.Choice;
import montiarc7.statement.Deed.Condition;
import montiarc7.statement.Deed.Said;
import montiarc7.statement.Deed.Sent;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** What statements do, one after the other. */
final class ActionReader {
    private final Scope scope;
    private final Course course;
    private final Outside outside;

    private ActionReader(Scope scope, Course course, Outside outside) {
        this.scope = scope;
        this.course = course;
        this.outside = outside;
    }

    static List<Deed> read(ParserRuleContext action, Scope scope) {
        Course course = new Course(LoopReader.counting(action));
        return new ActionReader(scope, course, Outside.of(action, scope)).inside(action);
    }

    Scope scope() {
        return scope.within(course);
    }

    Course course() {
        return course;
    }

    Counting counting() {
        return new Counting(course, scope.lacks());
    }

    private ExpressionWriter expressions() {
        return new ExpressionWriter(scope());
    }

    /** Without braces around the whole. */
    List<Deed> inside(ParserRuleContext action) {
        if (action instanceof BlockStatementContext block) {
            return inside(block.block());
        }
        if (action instanceof BlockContext block) {
            return all(block.statement());
        }
        return statement((StatementContext) action);
    }

    private List<Deed> all(List<StatementContext> statements) {
        List<Deed> deeds = new ArrayList<>();
        for (StatementContext each : statements) {
            if (course.next == Next.GO_ON) {
                deeds.addAll(statement(each));
            }
        }
        return deeds;
    }

    private List<Deed> statement(StatementContext statement) {
        if (statement instanceof BlockStatementContext) {
            return List.of(new Block(local(statement)));
        } else if (statement instanceof EmptyStatementContext) {
            return List.of();
        } else if (statement instanceof IfStatementContext choice) {
            return choice(choice);
        } else if (statement instanceof SwitchStatementContext choice) {
            return new SwitchReader(this).read(choice);
        } else if (outside.isLeftOut(statement)) {
            scope.lacks()
                    .note(
                            Lack.OUTSIDE,
                            statement,
                            statement instanceof CallStatementContext
                                    ? "this call is left out: what it does is done outside of the"
                                            + " model"
                                    : "this is left out: it is a matter of objects, into which"
                                            + " nothing that is converted looks");
            return List.of();
        } else if (statement instanceof AssignStatementContext assign) {
            String operator = assign.assign.getText();
            return assign(assign.expression(0), operator, assign.expression(1));
        } else if (statement instanceof AssignStepStatementContext assign) {
            return assignStep(assign);
        } else if (statement instanceof StepStatementContext step) {
            return step(step.expression(), step.step.getText());
        } else if (statement instanceof LocalStatementContext local) {
            return local.variable().stream()
                    .flatMap(each -> declare(local.type(), each).stream())
                    .toList();
        } else if (statement instanceof BreakStatementContext && course.isInRound) {
            course.next = Next.BEHIND;
            return List.of();
        } else if (statement instanceof ContinueStatementContext && course.isInRound) {
            course.next = Next.AGAIN;
            return List.of();
        }
        return new LoopReader(this).read(statement).orElseGet(() -> unknown(statement));
    }

    private List<Deed> unknown(StatementContext statement) {
        boolean leaves =
                statement instanceof BreakStatementContext
                        || statement instanceof ContinueStatementContext;
        String what = statement instanceof CallStatementContext ? "call" : "statement";
        refuse(
                statement,
                leaves && course.isInLoop
                        ? "whether a loop goes on here is known only while a model runs, and"
                                + " Arcomat has no loops; let it count from one number to another"
                        : "this %s cannot be said in Arcomat, whose actions have assignments, local variables and 'if'"
                                .formatted(what));
        return List.of();
    }

    void refuse(ParserRuleContext place, String message) {
        scope.lacks().missing(Lack.STATEMENT, place, message);
    }

    /** What is declared in it is forgotten. */
    private List<Deed> local(ParserRuleContext action) {
        return course.inBlock(() -> inside(action));
    }

    /** What is done where nobody knows beforehand whether it is. */
    List<Deed> branch(List<StatementContext> statements, Set<String> present) {
        Set<String> fixed = course.fixed;
        boolean isInRound = course.isInRound;
        course.fixed = course.known.values().keySet();
        course.isInRound = false;
        ActionReader reader = new ActionReader(scope.with(present), course, outside);
        List<Deed> deeds =
                course.inBlock(
                        () ->
                                statements.stream()
                                        .flatMap(each -> reader.inside(each).stream())
                                        .toList());
        course.fixed = fixed;
        course.isInRound = isInRound;
        return deeds;
    }

    private List<Deed> choice(IfStatementContext choice) {
        ExpressionContext asked = choice.expression();
        Optional<Boolean> holds = new Arithmetic(course.known).truth(asked);
        if (holds.isPresent() && course.known.speaksOf(Names.in(asked))) {
            int taken = holds.get() ? 0 : 1;
            return taken < choice.statement().size() ? taken(choice.statement(taken)) : List.of();
        }
        Set<String> present = new Guards(expressions()).presentIn(asked);
        Condition condition =
                new Condition(
                        expressions().write(asked), Optional.of(asked).filter(this::isOfInputs));
        List<Deed> then = branch(List.of(choice.statement(0)), present);
        List<Deed> otherwise =
                choice.statement().size() > 1
                        ? branch(List.of(choice.statement(1)), Set.of())
                        : List.of();
        return List.of(new Choice(condition, then, otherwise));
    }

    /** What is done for sure, in braces if it has names of its own. */
    private List<Deed> taken(StatementContext statement) {
        List<Deed> deeds = local(statement);
        return Deed.declare(deeds) ? List.of(new Block(deeds)) : deeds;
    }

    private boolean isOfInputs(ExpressionContext expression) {
        if (expression instanceof MemberExpressionContext member) {
            return expressions().isConstant(member);
        }
        if (expression instanceof NameExpressionContext name) {
            return scope.inputs().contains(name.getText());
        }
        return expression.children.stream()
                .filter(ExpressionContext.class::isInstance)
                .allMatch(each -> isOfInputs((ExpressionContext) each));
    }

    List<Deed> assign(ExpressionContext left, String operator, ExpressionContext value) {
        String target = target(left);
        if (counting().has(target)) {
            counting().change(left, target, operator, new Arithmetic(course.known).number(value));
            return List.of();
        }
        String name = course.known.text(target).orElse(target);
        String written = expressions().write(value);
        if (operator.matches("[*/%]=")) {
            String sign = operator.substring(0, 1);
            return List.of(said("%s = %s %s (%s)".formatted(name, name, sign, written), name));
        }
        if (!scope.outputs().contains(target) || !operator.equals("=")) {
            return List.of(said(name + " " + operator + " " + written, name));
        }
        boolean isAlone = value instanceof NameExpressionContext;
        Sent sent = new Sent(name, isAlone ? Guards.bare(written) : written, reads(value));
        // What is only passed on is passed on as silence, too.
        if (value instanceof NameExpressionContext port
                && scope.inputs().contains(port.getText())
                && !scope.present().contains(port.getText())) {
            Condition there = new Condition(port.getText() + " != --", Optional.empty());
            return List.of(new Choice(there, List.of(sent), List.of()));
        }
        return List.of(sent);
    }

    /** 'a = b++' and 'a = ++b'. */
    private List<Deed> assignStep(AssignStepStatementContext assign) {
        ExpressionContext value = assign.expression(1);
        List<Deed> deeds = new ArrayList<>();
        if (assign.before != null) {
            deeds.addAll(step(value, assign.before.getText()));
        }
        deeds.addAll(assign(assign.expression(0), "=", value));
        if (assign.step != null) {
            if (assign.expression(0).getText().equals(value.getText())) {
                return deeds; // Java assigns last what was there before
            }
            deeds.addAll(step(value, assign.step.getText()));
        }
        return deeds;
    }

    private static Said said(String text, String changed) {
        return new Said(text, changed, false);
    }

    List<Deed> step(ExpressionContext variable, String operator) {
        String target = target(variable);
        if (counting().has(target)) {
            String sign = operator.substring(1) + "=";
            counting().change(variable, target, sign, Optional.of(1));
            return List.of();
        }
        String name = course.known.text(target).orElse(target);
        return List.of(said(name + operator, name));
    }

    private String target(ExpressionContext expression) {
        String name = expression.getText().replaceFirst("^this\\.", "");
        if (!name.matches("[\\p{L}_$][\\p{L}\\p{N}_$]*") || scope.inputs().contains(name)) {
            refuse(
                    expression,
                    "nothing can be assigned to '%s' in Arcomat".formatted(expression.getText()));
        }
        return name;
    }

    private List<Deed> declare(TypeContext type, VariableContext variable) {
        String name = variable.name().getText();
        if (course.counting.contains(name) && counting().begin(type, variable)) {
            return List.of();
        }
        String written = free(name);
        String value =
                variable.expression() == null
                        ? ""
                        : " = " + expressions().write(variable.expression());
        if (!written.equals(name)) {
            course.known = course.known.calling(name, written);
        }
        course.declare(name, type);
        course.declared.add(written);
        return List.of(
                new Said(scope.types().message(type) + " " + written + value, written, true));
    }

    /** Each round of a loop declares its variables anew. */
    private String free(String name) {
        String free = name;
        for (int i = 2; course.declared.contains(free) || i > 2 && scope.lacks().says(free); i++) {
            free = name + i;
        }
        return free;
    }

    private Set<String> reads(ExpressionContext value) {
        Set<String> names = new HashSet<>();
        for (String each : Names.in(value)) {
            if (!scope.inputs().contains(each) && !course.known.values().containsKey(each)) {
                names.add(course.known.text(each).orElse(each));
            }
        }
        return names;
    }
}
