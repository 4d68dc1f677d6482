package arcomat.analysis.automaton.exploration;

import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.RunProperty.Difference;
import arcomat.analysis.reachability.Subject;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * What is known about an automaton after looking at it: by trying, and by the solver where that did
 * not see everything.
 *
 * @param shown by some run
 * @param answers to the questions that were put to the solver
 * @param traps what is known of them where not all configurations have been looked at
 */
public record Knowledge(
        Subject subject,
        Exploration explored,
        Set<RunProperty> shown,
        Map<RunProperty, Reachability> answers,
        Traps traps) {

    /** Before anybody has looked for traps. */
    public Knowledge(
            Subject subject,
            Exploration explored,
            Set<RunProperty> shown,
            Map<RunProperty, Reachability> answers) {
        this(subject, explored, shown, answers, Traps.NONE);
    }

    /** The same with what is known of traps. */
    public Knowledge with(Traps found) {
        return new Knowledge(subject, explored, shown, answers, found);
    }

    /** Whether all configurations have been looked at, one by one. */
    public boolean isExhaustive() {
        return explored.isComplete();
    }

    /** Whether there were too many questions for the solver. */
    public boolean isUnasked() {
        return !isExhaustive()
                && answers.isEmpty()
                && !shown.containsAll(new RunProperties(subject).all());
    }

    /** What no solver could tell, whether it matters or not. */
    public List<RunProperty> unknown() {
        return answers.keySet().stream()
                .filter(each -> answers.get(each) instanceof Reachability.Unknown)
                .filter(each -> !happens(each))
                .toList();
    }

    /** Whether something stays open that matters. */
    public boolean isOpen() {
        return answers.keySet().stream().anyMatch(this::isOpen);
    }

    /** Whether it stays open, and matters: how two transitions differ only where they meet. */
    private boolean isOpen(RunProperty property) {
        if (isCutOff(property)
                || !(answers.get(property) instanceof Reachability.Unknown)
                || happens(property)) {
            return false;
        }
        if (property instanceof RunProperty.Together together) {
            return switch (together.difference()) {
                case ANY -> true;
                case OUTPUT -> happens(together.with(Difference.ANY));
                case TARGET ->
                        happens(together.with(Difference.ANY))
                                && !happens(together.with(Difference.OUTPUT));
            };
        }
        return true;
    }

    /** Whether it asks for a state that no transitions lead to, whatever their guards say. */
    private boolean isCutOff(RunProperty property) {
        return property instanceof RunProperty.Reached reached
                && !explored.isConnected(reached.state());
    }

    /** Whether some run shows it. */
    public boolean happens(RunProperty property) {
        return shown.contains(property);
    }

    /** Whether certainly no run shows it. */
    public boolean neverHappens(RunProperty property) {
        if (happens(property)) {
            return false;
        }
        return isExhaustive()
                || isCutOff(property)
                || answers.get(property) instanceof Reachability.Unreachable;
    }

    /** Why not everything is known: what stays open; empty where nothing does. */
    public String obstacle() {
        if (isExhaustive()) {
            return "";
        }
        if (isUnasked()) {
            return explored.obstacle();
        }
        List<RunProperty> open = answers.keySet().stream().filter(this::isOpen).toList();
        if (!open.isEmpty()) {
            return words(open);
        }
        return traps.obstacle().isEmpty()
                ? ""
                : "it is open whether there is %s trap, where nothing is sent any more (%s)"
                        .formatted(traps.entered().isEmpty() ? "a" : "another", traps.obstacle());
    }

    private String words(List<RunProperty> open) {
        Reachability.Unknown first =
                (Reachability.Unknown) Objects.requireNonNull(answers.get(open.get(0)));
        String more = open.size() == 1 ? "" : ", and " + (open.size() - 1) + " more";
        return "it is open whether %s (%s)%s"
                .formatted(new RunProperties(subject).words(open.get(0)), first.reason(), more);
    }
}
