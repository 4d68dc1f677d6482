package montiarc7;

import montiarc7.grammar.MontiArc7Parser.AssignStatementContext;
import montiarc7.grammar.MontiArc7Parser.BlockContext;
import montiarc7.grammar.MontiArc7Parser.BlockStatementContext;
import montiarc7.grammar.MontiArc7Parser.StatementContext;
import montiarc7.source.Lack;
import montiarc7.statement.ActionWriter;
import montiarc7.statement.Scope;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** What is done at the start: only ports with a delay show what is sent then. */
final class StartWriter {
    private final Scope scope;
    private final Set<String> delayed;

    StartWriter(Scope scope, Set<String> delayed) {
        this.scope = scope;
        this.delayed = delayed;
    }

    String write(List<ParserRuleContext> actions) {
        List<StatementContext> kept = new ArrayList<>();
        actions.forEach(each -> keep(each, kept));
        return new ActionWriter(scope.atStart(delayed)).write(kept);
    }

    private void keep(ParserRuleContext action, List<StatementContext> kept) {
        if (action instanceof BlockStatementContext block) {
            keep(block.block(), kept);
        } else if (action instanceof BlockContext block) {
            block.statement().forEach(each -> keep(each, kept));
        } else if (action instanceof AssignStatementContext assign && isEarly(assign)) {
            scope.lacks()
                    .note(
                            Lack.START,
                            action,
                            "what '%s' sends at the start is left out: a port without delay has no message before the first slice"
                                    .formatted(assign.expression(0).getText()));
        } else {
            kept.add((StatementContext) action);
        }
    }

    private boolean isEarly(AssignStatementContext assign) {
        String name = assign.expression(0).getText();
        return scope.outputs().contains(name) && !delayed.contains(name);
    }
}
