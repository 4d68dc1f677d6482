package arcomat.syntax;

import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.atn.ATN;
import org.antlr.v4.runtime.atn.ATNState;
import org.antlr.v4.runtime.atn.PrecedencePredicateTransition;
import org.antlr.v4.runtime.atn.RuleStopState;
import org.antlr.v4.runtime.atn.RuleTransition;
import org.antlr.v4.runtime.atn.Transition;
import org.antlr.v4.runtime.misc.IntervalSet;
import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

/**
 * All ways through a grammar at once, token by token: a simulation of the network of states that
 * ANTLR makes of it, with a stack of the rules that have been entered (the LL simulation of Parr,
 * Harwell, Fisher, <i>Adaptive LL(*) parsing</i>, OOPSLA 2014, without its lookahead). A parser
 * tells what it expected at an error; this tells all that could come, however many ways lead there.
 */
final class GrammarWalk {
    private final ATN network;
    private Set<Way> ways = new LinkedHashSet<>();

    /**
     * Where one way has come to.
     *
     * @param precedence the loosest operator that the current rule may go on with
     * @param calls the rules that have been entered and not left; null at the entry rule
     */
    private record Way(ATNState state, int precedence, @Nullable Call calls) {}

    /**
     * A rule that waits for another one to end.
     *
     * @param then where it goes on
     * @param precedence its own
     */
    private record Call(ATNState then, int precedence, @Nullable Call above) {}

    GrammarWalk(ATN network, int entryRule) {
        this.network = network;
        ways.add(new Way(network.ruleToStartState[entryRule], 0, null));
        close();
    }

    /** Goes on with a token; where no way can, none is left. */
    void take(int token) {
        Set<Way> next = new LinkedHashSet<>();
        for (Way way : ways) {
            for (Transition transition : way.state().getTransitions()) {
                if (!transition.isEpsilon() && labels(transition).contains(token)) {
                    next.add(new Way(transition.target, way.precedence(), way.calls()));
                }
            }
        }
        ways = next;
        close();
    }

    private IntervalSet labels(Transition transition) {
        IntervalSet all = IntervalSet.of(Token.MIN_USER_TOKEN_TYPE, network.maxTokenType);
        return switch (transition.getSerializationType()) {
            case Transition.WILDCARD -> all;
            case Transition.NOT_SET -> all.subtract(transition.label());
            default -> transition.label();
        };
    }

    /** Follows all steps that take no token. */
    private void close() {
        Deque<Way> open = new ArrayDeque<>(ways);
        while (!open.isEmpty()) {
            for (Way next : silent(open.remove())) {
                if (ways.add(next)) {
                    open.add(next);
                }
            }
        }
    }

    private static List<Way> silent(Way way) {
        List<Way> next = new ArrayList<>();
        Call calls = way.calls();
        if (way.state() instanceof RuleStopState) {
            if (calls != null) {
                next.add(new Way(calls.then(), calls.precedence(), calls.above()));
            }
            return next;
        }
        for (Transition transition : way.state().getTransitions()) {
            if (transition instanceof RuleTransition rule) {
                Call call = new Call(rule.followState, way.precedence(), calls);
                next.add(new Way(rule.target, rule.precedence, call));
            } else if (transition.isEpsilon() && isOpen(transition, way.precedence())) {
                next.add(new Way(transition.target, way.precedence(), calls));
            }
        }
        return next;
    }

    private static boolean isOpen(Transition transition, int precedence) {
        return !(transition instanceof PrecedencePredicateTransition predicate)
                || predicate.precedence >= precedence;
    }

    /**
     * What could come next.
     *
     * @param name a rule that is told as a whole, and not by the tokens that it begins with
     * @param token told the type of each token that could come, but for those of that rule; where
     *     any token could come, none is told
     * @param names told the rules around each place where that rule could begin, innermost first
     */
    void next(int name, IntConsumer token, Consumer<List<Integer>> names) {
        Set<Integer> types = new TreeSet<>();
        for (Way way : ways) {
            if (way.state() == network.ruleToStartState[name]) {
                names.accept(rules(way.calls()));
            } else if (way.state().ruleIndex != name) {
                for (Transition transition : way.state().getTransitions()) {
                    if (transition.label() != null && !isAnyOther(transition)) {
                        types.addAll(transition.label().toList());
                    }
                }
            }
        }
        types.forEach(token::accept);
    }

    private static boolean isAnyOther(Transition transition) {
        return transition.getSerializationType() == Transition.NOT_SET;
    }

    private static List<Integer> rules(@Nullable Call innermost) {
        List<Integer> rules = new ArrayList<>();
        for (Call call = innermost; call != null; call = call.above()) {
            rules.add(call.then().ruleIndex);
        }
        return rules;
    }
}
