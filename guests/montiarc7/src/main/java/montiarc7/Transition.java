package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ReactionContext;
import montiarc7.grammar.MontiArc7Parser.StatementContext;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.Optional;

/**
 * A transition as it is written.
 *
 * @param from the state in which it begins
 * @param to the state that it enters; none where it stays within the one in which it begins
 */
record Transition(
        ParserRuleContext place, String from, Optional<String> to, ReactionContext reaction) {
    /** Whether it neither leaves nor enters the state in which it begins. */
    boolean isWithin() {
        return to.isEmpty();
    }

    /** Null where it has none. */
    ExpressionContext guard() {
        return reaction.expression();
    }

    /** Null where it has none. */
    StatementContext action() {
        return reaction.statement();
    }

    /** The port whose message takes the transition; none where it is taken in a slice. */
    Optional<String> trigger() {
        return Optional.ofNullable(reaction.qname())
                .map(ParserRuleContext::getText)
                .filter(each -> !each.equals("Tick"));
    }
}
