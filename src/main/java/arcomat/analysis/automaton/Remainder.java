package arcomat.analysis.automaton;

import arcomat.analysis.smt.Reachability;
import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.Subject;

import java.util.List;
import java.util.Map;

/** What a reader has to know beside the findings: what stays open. */
record Remainder(Subject subject, Knowledge knowledge) {

    /** Why not everything is known; empty where it is. */
    String obstacle() {
        if (knowledge.isExhaustive()) {
            return "";
        }
        if (knowledge.outcomes().isEmpty()) {
            return knowledge.explored().obstacle();
        }
        List<Map.Entry<RunProperty, Reachability>> open =
                knowledge.outcomes().entrySet().stream()
                        .filter(each -> knowledge.isOpen(each.getKey()))
                        .toList();
        if (!open.isEmpty()) {
            return words(open);
        }
        return new SureSending(subject, knowledge).isOpen()
                ? "it is open whether there is a trap, where nothing is sent any more (%s)"
                        .formatted(knowledge.explored().obstacle())
                : "";
    }

    private String words(List<Map.Entry<RunProperty, Reachability>> open) {
        Reachability.Unknown first = (Reachability.Unknown) open.get(0).getValue();
        String more = open.size() == 1 ? "" : ", and " + (open.size() - 1) + " more";
        return "it is open whether %s (%s)%s"
                .formatted(
                        new Questions(subject).words(open.get(0).getKey()), first.reason(), more);
    }
}
