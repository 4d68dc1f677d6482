package arcomat.analysis.coupling;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Match;
import arcomat.model.Automaton.Messages;
import arcomat.model.Automaton.OneOf;
import arcomat.model.Automaton.Pattern;
import arcomat.model.Automaton.Send;
import arcomat.model.Automaton.Transition;
import arcomat.model.Expression;
import arcomat.model.Port;

import java.util.List;
import java.util.Map;

/**
 * An automaton that reads ports where another one reads variables.
 *
 * @param memory the ports, by the names of the variables
 */
record OpenedAutomaton(Map<String, Port> memory) {
    Automaton of(Automaton automaton) {
        return automaton.withTransitions(automaton.transitions().stream().map(this::of).toList());
    }

    private Transition of(Transition transition) {
        return transition.with(
                transition.guard().map(this::of),
                transition.matches().stream().map(this::of).toList(),
                transition.sends().stream().map(this::of).toList(),
                transition.assignments().stream()
                        .map(each -> new Assignment(each.variable(), of(each.value())))
                        .toList());
    }

    private Match of(Match match) {
        return new Match(
                match.port(),
                match.pattern()
                        .<Pattern>match(
                                some -> new OneOf(of(some.values())),
                                match::pattern,
                                match::pattern));
    }

    private Send of(Send send) {
        return new Send(
                send.port(),
                send.emission()
                        .<Automaton.Emission>match(
                                some -> new Messages(of(some.values())),
                                send::emission,
                                send::emission));
    }

    private List<Expression> of(List<Expression> expressions) {
        return expressions.stream().map(this::of).toList();
    }

    private Expression of(Expression expression) {
        return expression.rewritten(this::read);
    }

    private Expression read(Expression leaf) {
        if (leaf instanceof Expression.VariableRead read) {
            Port port = memory.get(read.variable().name());
            return port == null ? leaf : new Expression.PortRead(port, read.span());
        }
        return leaf;
    }
}
