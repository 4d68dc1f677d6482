package statemachine;

import arcomat.guest.Meaning;
import arcomat.source.Nearest;

import statemachine.Machine.Beginning;
import statemachine.Machine.Label;
import statemachine.Machine.Memory;
import statemachine.Machine.State;
import statemachine.Machine.Target;
import statemachine.Machine.Transition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What has to be so, before a machine means anything: names are known, and it is said where to
 * begin.
 */
record MachineLaws(Machine machine, StateTree states, Meaning meaning) {
    void check() {
        for (Label each : states.doubles()) {
            Mistake.NAMED_TWICE.tell(
                    meaning,
                    each.place(),
                    "there is a state '%s' already; states of a machine have different names",
                    each.text());
        }
        beginning(machine.root(), "the machine");
        List<State> all = new ArrayList<>();
        states.paths().values().forEach(path -> all.add(path.get(path.size() - 1)));
        for (State each : all) {
            beginning(each, "state '" + each.name().text() + "'");
        }
        states.transitions().forEach(this::transition);
    }

    private void beginning(State whole, String name) {
        Optional<Beginning> initial = whole.initial();
        if (initial.isEmpty()) {
            if (!whole.isSimple() || whole.equals(machine.root())) {
                Mistake.NO_BEGINNING.tell(
                        meaning,
                        whole.name().place(),
                        "%s does not say where it begins; write 'initial' and a state of it",
                        name);
            }
            return;
        }
        Label state = initial.get().state();
        if (whole.states().stream().noneMatch(each -> each.name().text().equals(state.text()))) {
            Mistake.NO_BEGINNING.tell(
                    meaning,
                    state.place(),
                    "%s begins with a state that stands directly in it, which '%s' does not",
                    name,
                    state.text());
        }
    }

    private void transition(Transition transition) {
        known(transition.source());
        transition.target().ifPresent(this::target);
    }

    private void target(Target target) {
        known(target.state());
        if (target.memory() != Memory.NONE
                && states.find(target.state()).filter(State::isSimple).isPresent()) {
            Mistake.NOTHING_TO_REMEMBER.tell(
                    meaning,
                    target.state().place(),
                    "there is no state in '%s' that could be gone on with; leave out the history",
                    target.state().text());
        }
    }

    private void known(Label name) {
        if (states.find(name).isEmpty()) {
            String nearest =
                    Nearest.to(name.text(), states.paths().keySet())
                            .map(other -> "; did you mean '%s'?".formatted(other))
                            .orElse("; declare it");
            Mistake.UNKNOWN_STATE.tell(
                    meaning, name.place(), "there is no state '%s'%s", name.text(), nearest);
        }
    }
}
