package arcomat.generate.monitor;

import arcomat.generate.language.NameForms;
import arcomat.generate.plan.Program;
import arcomat.generate.view.MonitorView;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.source.Span;

import java.util.List;

/**
 * A class that watches for one requirement.
 *
 * @param watched the component of the model that has the requirement, as the requirement sees it
 * @param component what the class is to the rest of the generator: it has the ports of the one that
 *     is watched, and a single automaton
 */
public record MonitorClass(Component watched, Automaton automaton, Component component) {

    public static MonitorClass of(Component watched, Automaton automaton) {
        Component promised = watched.asPromised();
        boolean sole = watched.automata().size() == 1;
        String infix = sole ? "" : NameForms.capitalised(requirement(promised, automaton));
        return new MonitorClass(
                promised,
                automaton,
                component(promised, infix, List.of(automaton), automaton.span()));
    }

    /** The name of the requirement among those of its component. */
    public String requirement() {
        return requirement(watched, automaton);
    }

    private static String requirement(Component watched, Automaton automaton) {
        return automaton.name().isEmpty()
                ? "Automaton" + (watched.automata().indexOf(automaton) + 1)
                : automaton.name();
    }

    public MonitorView view(Program program) {
        return new MonitorViews(watched, automaton, program.context(component)).view();
    }

    public static Component component(
            Component watched, String infix, List<Automaton> automata, Span span) {
        return watched.like(
                watched.name() + infix + "Monitor",
                watched.ports(),
                new Component.Atomic(automata),
                span);
    }
}
