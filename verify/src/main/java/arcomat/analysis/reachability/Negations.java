package arcomat.analysis.reachability;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.Guards;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The negations in guards that have nothing to negate where a port is silent, and whose authors
 * seem not to have thought of that.
 */
record Negations(Component.Profile profile, Automaton automaton, Guards guards) {

    /**
     * Those of a transition; none about a port whose silence another one out of its state minds.
     */
    List<Expression> of(Automaton.Transition transition) {
        Set<String> minded = portsWithSilenceInMind(transition.source());
        return guards.negations(transition).stream()
                .filter(each -> each.ports().stream().allMatch(this::staysSilent))
                .filter(each -> each.ports().stream().noneMatch(p -> minded.contains(p.name())))
                .toList();
    }

    /** An event comes on one port: that the others carry none then is no silence. */
    private boolean staysSilent(Port port) {
        return profile == Component.Profile.TIME_SYNCHRONOUS || port.latched();
    }

    /** Who asks for silence, or for any message, has thought of both. */
    private Set<String> portsWithSilenceInMind(int state) {
        Set<String> ports = new HashSet<>();
        for (Automaton.Transition each : automaton.transitions()) {
            if (each.source() == state) {
                each.matches().forEach(match -> add(match.port(), match.pattern(), ports));
                each.guard().ifPresent(guard -> guard.visit(part -> add(part, ports)));
            }
        }
        return ports;
    }

    private static void add(Expression part, Set<String> ports) {
        if (part instanceof Expression.PortMatches matches) {
            add(matches.port(), matches.pattern(), ports);
        }
    }

    private static void add(Port port, Automaton.Pattern pattern, Set<String> ports) {
        if (pattern.values().isEmpty()) {
            ports.add(port.name());
        }
    }
}
