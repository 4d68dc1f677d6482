package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BlockContext;
import montiarc7.grammar.MontiArc7Parser.BlockStatementContext;
import montiarc7.grammar.MontiArc7Parser.BreakStatementContext;
import montiarc7.grammar.MontiArc7Parser.StatementContext;
import montiarc7.grammar.MontiArc7Parser.SwitchCaseContext;
import montiarc7.grammar.MontiArc7Parser.SwitchStatementContext;
import montiarc7.statement.Deed.Choice;
import montiarc7.statement.Deed.Condition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A choice among values as a chain of 'if'. No case goes on in the next one, but for those that
 * have no statements, which stand for the same.
 */
final class SwitchReader {
    private final ActionReader reader;
    private final ExpressionWriter expressions;

    SwitchReader(ActionReader reader) {
        this.reader = reader;
        this.expressions = new ExpressionWriter(reader.scope());
    }

    List<Deed> read(SwitchStatementContext choice) {
        String written = expressions.write(choice.expression());
        String value = written.matches("\\w+") ? written : "(" + written + ")";
        Set<String> present = expressions.reads(choice.expression());
        List<Choice> cases = new ArrayList<>();
        List<String> same = new ArrayList<>();
        boolean isDefault = false;
        List<Deed> otherwise = List.of();
        for (SwitchCaseContext each : choice.switchCase()) {
            isDefault |= each.expression() == null;
            if (each.expression() != null) {
                same.add(value + " == " + expressions.write(each.expression()));
            }
            if (each.statement().isEmpty()) {
                continue;
            }
            List<Deed> done = reader.branch(withoutBreak(each.statement()), present);
            if (isDefault) {
                otherwise = done;
            } else {
                Condition condition = new Condition(String.join(" || ", same), Optional.empty());
                cases.add(new Choice(condition, done, List.of()));
            }
            same.clear();
            isDefault = false;
        }
        for (int i = cases.size() - 1; i >= 0; i--) {
            Choice each = cases.get(i);
            otherwise = List.of(new Choice(each.condition(), each.then(), otherwise));
        }
        return otherwise;
    }

    /** Statements of a case, which may end with a 'break' that says nothing more. */
    private static List<StatementContext> withoutBreak(List<StatementContext> statements) {
        List<StatementContext> all = new ArrayList<>(statements);
        if (all.size() == 1 && all.get(0) instanceof BlockStatementContext only) {
            BlockContext block = only.block();
            all = new ArrayList<>(block.statement());
        }
        if (!all.isEmpty() && all.get(all.size() - 1) instanceof BreakStatementContext) {
            all.remove(all.size() - 1);
        }
        return all;
    }
}
