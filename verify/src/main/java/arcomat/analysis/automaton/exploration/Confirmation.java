package arcomat.analysis.automaton.exploration;

import arcomat.analysis.reachability.Reachability.Place;
import arcomat.analysis.reachability.Reachability.Run;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.value.InputAbstraction;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Makes a run that the solver found concrete: goes its way with the automaton's own steps, and only
 * what is seen there counts. On the way messages that make no difference are left out.
 */
public record Confirmation(Subject subject, Stepper stepper) {

    /** The situation at the end, if the way is there and the end shows what was asked. */
    public Optional<Situation> of(RunProperty property, Run run) {
        return reaching(run, Set.of()).flatMap(end -> end(end, run, property));
    }

    /**
     * Where a run ends, before its last letter, if the way is there.
     *
     * @param kept positions of ports whose messages are not left out
     */
    public Optional<Visit> reaching(Run run, Set<Integer> kept) {
        Optional<Visit> visit = beginning(run.places().get(0));
        for (int i = 0; i < run.letters().size() && visit.isPresent(); i++) {
            visit = step(visit.get(), run.letters().get(i), run.places().get(i + 1), kept);
        }
        return visit;
    }

    private Optional<Situation> end(Visit end, Run run, RunProperty property) {
        Predicate<Value[]> shows = letter -> situation(end, letter).shows().contains(property);
        return shows.test(run.last())
                ? Optional.of(situation(end, withoutNeedless(end, run.last(), Set.of(), shows)))
                : Optional.empty();
    }

    private Situation situation(Visit visit, Value[] letter) {
        return stepper.situation(visit, letter, reaction -> -1);
    }

    private Optional<Visit> beginning(Place place) {
        for (Start start : subject.relation().starts()) {
            if (isAt(start.configuration(), place)) {
                return Optional.of(Visit.beginning(start.configuration(), start.output()));
            }
        }
        return Optional.empty();
    }

    private Optional<Visit> step(Visit before, Value[] found, Place place, Set<Integer> kept) {
        Predicate<Value[]> leads = letter -> reaction(before, letter, place).isPresent();
        if (!leads.test(found)) {
            return Optional.empty();
        }
        Value[] letter = withoutNeedless(before, found, kept, leads);
        Reaction reaction = reaction(before, letter, place).orElseThrow();
        return Optional.of(before.then(reaction, stepper.latched(before, letter), letter));
    }

    private Optional<Reaction> reaction(Visit before, Value[] letter, Place place) {
        return situation(before, letter).alternatives().stream()
                .flatMap(each -> each.reaction().stream())
                .filter(each -> isAt(each.next(), place))
                .findFirst();
    }

    private static boolean isAt(Configuration configuration, Place place) {
        return configuration.state() == place.state()
                && configuration.variables().equals(place.variables());
    }

    private Value[] withoutNeedless(
            Visit visit, Value[] found, Set<Integer> kept, Predicate<Value[]> enough) {
        Value[] letter = found;
        List<Port> inputs = subject.component().inputs();
        for (int port = 0; port < letter.length; port++) {
            if (letter[port] != null
                    && !kept.contains(port)
                    && mayBeSilent(inputs.get(port), port, visit)) {
                Value[] less = letter.clone();
                less[port] = null;
                letter = enough.test(less) ? less : letter;
            }
        }
        return letter;
    }

    /** Neither total, nor the event itself, nor latched before. */
    private boolean mayBeSilent(Port port, int position, Visit visit) {
        boolean timed = subject.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        if (timed) {
            return !port.total();
        }
        InputAbstraction abstraction = subject.relation().abstraction(visit.configuration());
        return port.latched()
                && (!visit.latched().contains(position)
                        || abstraction.looks().get(position) instanceof InputAbstraction.Unseen);
    }
}
