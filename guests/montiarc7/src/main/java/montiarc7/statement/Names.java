package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.MemberExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.HashSet;
import java.util.Set;

/** The names of variables and ports that something speaks of. */
final class Names {
    private Names() {}

    static Set<String> in(ParserRuleContext tree) {
        Set<String> names = new HashSet<>();
        if (tree instanceof NameExpressionContext) {
            names.add(tree.getText());
        } else if (tree instanceof MemberExpressionContext member
                && member.expression().getText().equals("this")) {
            names.add(member.name().getText());
        }
        for (var child : tree.children) {
            if (child instanceof ParserRuleContext inner) {
                names.addAll(in(inner));
            }
        }
        return names;
    }
}
