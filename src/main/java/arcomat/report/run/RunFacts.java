package arcomat.report.run;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.report.page.Story.Fact;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** What a run depends on, in words. */
public final class RunFacts {
    private RunFacts() {}

    /** How time passes. */
    public static Fact time(Component component) {
        return switch (component.profile()) {
            case TIME_SYNCHRONOUS ->
                    Fact.of("time", "in slices: each port has one message or none in each of them");
            case EVENT_DRIVEN ->
                    Fact.of("time", "event by event: a step is one message and all that it causes");
        };
    }

    /** What happens where no transition fits; nothing of what has no automata of its own. */
    public static Optional<Fact> completions(Component component, List<Automaton> automata) {
        String words =
                automata.stream()
                        .map(each -> completion(component, each, automata.size() > 1))
                        .collect(Collectors.joining("; "));
        return words.isEmpty()
                ? Optional.empty()
                : Optional.of(new Fact("completion", "where no transition fits, " + words));
    }

    private static String completion(Component component, Automaton automaton, boolean several) {
        String who = several ? component.title(automaton) + ": " : "";
        return who
                + switch (automaton.completion()) {
                    case IGNORE -> "the input is ignored";
                    case ERROR -> "it is an error";
                    case OUTPUT -> "the state stays and any output is allowed";
                    case CHAOS -> "anything is allowed from there on";
                };
    }
}
