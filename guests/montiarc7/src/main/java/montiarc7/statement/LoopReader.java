package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BreakStatementContext;
import montiarc7.grammar.MontiArc7Parser.ChangeContext;
import montiarc7.grammar.MontiArc7Parser.ContinueStatementContext;
import montiarc7.grammar.MontiArc7Parser.DoStatementContext;
import montiarc7.grammar.MontiArc7Parser.EachStatementContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ForStatementContext;
import montiarc7.grammar.MontiArc7Parser.IfStatementContext;
import montiarc7.grammar.MontiArc7Parser.StatementContext;
import montiarc7.grammar.MontiArc7Parser.VariableContext;
import montiarc7.grammar.MontiArc7Parser.WhileStatementContext;
import montiarc7.statement.Course.Next;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Loops of which is known beforehand how often they go round: the rounds are written one after the
 * other, with numbers in the place of what counts.
 */
final class LoopReader {
    private static final int MOST_ROUNDS = 256;

    private final ActionReader reader;
    private final Course course;

    LoopReader(ActionReader reader) {
        this.reader = reader;
        this.course = reader.course();
    }

    /** What loops ask for: in their conditions, and in front of 'break' and 'continue'. */
    static Set<String> counting(ParserRuleContext action) {
        Set<String> names = new HashSet<>();
        collect(action, false, names);
        return names;
    }

    private static void collect(ParserRuleContext tree, boolean isInLoop, Set<String> names) {
        boolean isLoop = isLoop(tree);
        if (isLoop || isInLoop && tree instanceof IfStatementContext && leaves(tree)) {
            condition(tree).ifPresent(each -> names.addAll(Names.in(each)));
        }
        for (var child : tree.children) {
            if (child instanceof ParserRuleContext inner && inner.children != null) {
                collect(inner, isInLoop || isLoop, names);
            }
        }
    }

    private static boolean isLoop(ParserRuleContext tree) {
        return tree instanceof ForStatementContext
                || tree instanceof WhileStatementContext
                || tree instanceof DoStatementContext;
    }

    private static Optional<ExpressionContext> condition(ParserRuleContext tree) {
        return Optional.ofNullable(tree.getRuleContext(ExpressionContext.class, 0));
    }

    private static boolean leaves(ParserRuleContext tree) {
        if (tree instanceof BreakStatementContext || tree instanceof ContinueStatementContext) {
            return true;
        }
        return tree.children.stream()
                .anyMatch(
                        each ->
                                each instanceof ParserRuleContext inner
                                        && inner.children != null
                                        && leaves(inner));
    }

    /** Nothing where it is no loop. */
    Optional<List<Deed>> read(StatementContext statement) {
        Known outer = course.known;
        List<Deed> deeds = new ArrayList<>();
        if (statement instanceof EachStatementContext each) {
            reader.refuse(
                    each.expression(),
                    "what '%s' holds is known only while a model runs, and Arcomat has no loops; let a loop count from one number to another"
                            .formatted(each.expression().getText()));
        } else if (statement instanceof ForStatementContext loop) {
            start(loop, deeds);
            Optional<ExpressionContext> condition = Optional.ofNullable(loop.expression());
            rounds(statement, condition, true, loop.statement(), loop.change(), deeds);
        } else if (statement instanceof WhileStatementContext loop) {
            rounds(statement, condition(loop), true, loop.statement(), List.of(), deeds);
        } else if (statement instanceof DoStatementContext loop) {
            rounds(statement, condition(loop), false, loop.statement(), List.of(), deeds);
        } else {
            return Optional.empty();
        }
        course.known = course.known.of(outer);
        return Optional.of(deeds);
    }

    private void start(ForStatementContext loop, List<Deed> deeds) {
        if (loop.loopStart() == null) {
            return;
        }
        loop.loopStart().change().forEach(each -> deeds.addAll(change(each)));
        for (VariableContext each : loop.loopStart().variable()) {
            if (!reader.counting().begin(loop.loopStart().type(), each)) {
                reader.refuse(
                        each,
                        "where this loop begins is known only while a model runs, and Arcomat has"
                                + " no loops; let it count from one number to another");
            }
        }
    }

    private void rounds(
            StatementContext loop,
            Optional<ExpressionContext> condition,
            boolean asksFirst,
            StatementContext body,
            List<ChangeContext> changes,
            List<Deed> deeds) {
        boolean wasInRound = course.isInRound;
        boolean wasInLoop = course.isInLoop;
        course.isInLoop = true;
        boolean goesOn = !asksFirst || holds(loop, condition);
        while (goesOn) {
            course.rounds++;
            if (course.rounds > MOST_ROUNDS) {
                reader.refuse(
                        loop,
                        "the loops of this action go round more than %d times; Arcomat has no loops, and what they do is too much to be written out"
                                .formatted(MOST_ROUNDS));
                break;
            }
            course.isInRound = true;
            course.next = Next.GO_ON;
            deeds.addAll(course.inRound(() -> reader.inside(body)));
            if (course.next != Next.BEHIND) {
                course.next = Next.GO_ON;
                changes.forEach(each -> deeds.addAll(change(each)));
            }
            goesOn = course.next != Next.BEHIND && holds(loop, condition);
        }
        course.isInRound = wasInRound;
        course.isInLoop = wasInLoop;
        course.next = Next.GO_ON;
    }

    private boolean holds(StatementContext loop, Optional<ExpressionContext> condition) {
        if (condition.isEmpty()) {
            return true;
        }
        Optional<Boolean> holds = new Arithmetic(course.known).truth(condition.get());
        if (holds.isEmpty()) {
            reader.refuse(
                    loop,
                    "how often this loop goes round is known only while a model runs, and Arcomat"
                            + " has no loops; let it count from one number to another");
        }
        return holds.orElse(false);
    }

    private List<Deed> change(ChangeContext change) {
        return change.assign == null
                ? reader.step(change.expression(0), change.step.getText())
                : reader.assign(
                        change.expression(0), change.assign.getText(), change.expression(1));
    }
}
