package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.AssignStatementContext;
import montiarc7.grammar.MontiArc7Parser.AssignStepStatementContext;
import montiarc7.grammar.MontiArc7Parser.StepStatementContext;
import montiarc7.statement.Deed.Block;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Actions as statements behind 'do', which are sequential there as they are in MontiArc. */
public final class ActionWriter {
    private final Scope scope;

    public ActionWriter(Scope scope) {
        this.scope = scope;
    }

    /** What is done one after the other; empty where nothing is. */
    public String write(List<? extends ParserRuleContext> actions) {
        List<Deed> deeds = new ArrayList<>();
        for (ParserRuleContext action : actions) {
            List<Deed> done = ActionReader.read(action, scope);
            // Names that are declared in one action are not known in the next one.
            if (actions.size() > 1 && Deed.declare(done)) {
                deeds.add(new Block(done));
            } else {
                deeds.addAll(done);
            }
        }
        return actions.isEmpty()
                ? ""
                : Deed.text(new Sending(scope, actions.get(0)).together(deeds));
    }

    /** Whether something may be sent. */
    public boolean sends(ParserRuleContext action) {
        return !assigned(action, true).isEmpty();
    }

    /** The names that something is assigned to, but for ports. */
    public Set<String> assigned(ParserRuleContext action) {
        return assigned(action, false);
    }

    private Set<String> assigned(ParserRuleContext action, boolean ports) {
        Set<String> names = new HashSet<>();
        if (action instanceof AssignStatementContext assign) {
            names.add(assign.expression(0).getText());
        } else if (action instanceof StepStatementContext step) {
            names.add(step.expression().getText());
        } else if (action instanceof AssignStepStatementContext assign) {
            assign.expression().forEach(each -> names.add(each.getText()));
        } else if (action.children != null) {
            for (var child : action.children) {
                if (child instanceof ParserRuleContext inner) {
                    names.addAll(assigned(inner, ports));
                }
            }
        }
        names.removeIf(each -> scope.outputs().contains(each) != ports);
        return names;
    }
}
