package montiarc7;

import montiarc7.MontiArc7Parser.BlockContext;
import montiarc7.MontiArc7Parser.BlockStatementContext;
import montiarc7.MontiArc7Parser.BreakStatementContext;
import montiarc7.MontiArc7Parser.StatementContext;
import montiarc7.MontiArc7Parser.SwitchCaseContext;
import montiarc7.MontiArc7Parser.SwitchStatementContext;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A choice among values as a chain of 'if'. No case goes on in the next one, but for those that
 * have no statements, which stand for the same.
 */
final class SwitchWriter {
    private final Scope scope;
    private final ExpressionWriter expressions;

    SwitchWriter(Scope scope) {
        this.scope = scope;
        this.expressions = new ExpressionWriter(scope);
    }

    String write(SwitchStatementContext choice) {
        String written = expressions.write(choice.expression());
        String value = written.matches("\\w+") ? written : "(" + written + ")";
        Set<String> present = expressions.reads(choice.expression());
        ActionWriter inside = new ActionWriter(scope.with(present));
        StringBuilder text = new StringBuilder();
        List<String> same = new ArrayList<>();
        boolean isDefault = false;
        String otherwise = "";
        for (SwitchCaseContext each : choice.switchCase()) {
            isDefault |= each.expression() == null;
            if (each.expression() != null) {
                same.add(value + " == " + expressions.write(each.expression()));
            }
            if (each.statement().isEmpty()) {
                continue;
            }
            StringBuilder done = new StringBuilder();
            withoutBreak(each.statement()).forEach(one -> done.append(inside.inside(one)));
            if (isDefault) {
                otherwise = done.toString();
            } else {
                text.append(text.isEmpty() ? "if (" : " else if (");
                text.append(String.join(" || ", same)).append(") {").append(done).append("}");
            }
            same.clear();
            isDefault = false;
        }
        return text.isEmpty()
                ? otherwise
                : text + (otherwise.isBlank() ? "" : " else {" + otherwise + "}") + "\n";
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
