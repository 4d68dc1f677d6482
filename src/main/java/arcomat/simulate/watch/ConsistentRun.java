package arcomat.simulate.watch;

import arcomat.model.Automaton;
import arcomat.model.Trace;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Output;
import arcomat.source.Span;

import java.util.Locale;

/**
 * A run of a requirement that agrees with what was seen.
 *
 * @param cause what its last step was, in words
 * @param promised per output port, what is to be seen of that step
 */
record ConsistentRun(String cause, Configuration configuration, Output promised) {

    static ConsistentRun of(Automaton automaton, Start start) {
        String state = automaton.states().get(start.initial().state());
        String cause = line(start.initial().span()) + ": initial " + state;
        return new ConsistentRun(cause, start.configuration(), start.output());
    }

    static ConsistentRun of(Automaton automaton, Configuration before, Reaction reaction) {
        return new ConsistentRun(
                cause(automaton, before, reaction), reaction.next(), reaction.output());
    }

    private static String cause(Automaton automaton, Configuration before, Reaction reaction) {
        if (reaction.cause() instanceof Trace.Taken taken) {
            Automaton.Transition transition = taken.transition();
            return line(transition.span()) + ": " + automaton.arrow(transition);
        }
        String where = before.isState() ? automaton.states().get(before.state()) : "chaos";
        String completion = automaton.completion().name().toLowerCase(Locale.ROOT);
        return "no transition fits in " + where + ", completion " + completion;
    }

    private static String line(Span span) {
        return "line " + span.startPosition().line();
    }

    boolean isChaos() {
        return configuration == Configuration.CHAOS;
    }
}
