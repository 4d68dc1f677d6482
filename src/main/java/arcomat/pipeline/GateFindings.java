package arcomat.pipeline;

import arcomat.analysis.Change;
import arcomat.analysis.Gate;
import arcomat.analysis.Verdict.Sentence;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** What the gate found, with the places in both models. */
final class GateFindings {
    private static final String NOT_KEPT = "ARC1101";
    private static final String GONE = "ARC1102";
    private static final String UNNEEDED_REASON = "ARC1103";
    private static final String UNKNOWN = "ARC1104";

    private final GateSide fresh;
    private final Excuses excuses;
    private final List<Diagnostic> findings = new ArrayList<>();

    private GateFindings(GateSide fresh, Excuses excuses) {
        this.fresh = fresh;
        this.excuses = excuses;
    }

    static List<Diagnostic> of(Gate gate, GateSide fresh, Excuses excuses) {
        GateFindings all = new GateFindings(fresh, excuses);
        for (Gate.Entry entry : gate.entries()) {
            switch (entry.answer()) {
                case HOLDS -> {}
                case FAILS -> all.fails(entry);
                case UNKNOWN -> all.unknown(entry);
            }
        }
        fresh.components().entrySet().stream()
                .filter(each -> fresh.isNamedByUser(each.getValue()))
                .forEach(all::unneeded);
        all.findings.sort(Diagnostic.ORDER);
        return all.findings;
    }

    private void fails(Gate.Entry entry) {
        if (entry.change().relation() == Change.Relation.GONE) {
            findings.add(
                    Diagnostic.error(
                            GONE,
                            entry.old().orElseThrow(),
                            "'"
                                    + entry.name()
                                    + "' is gone; keep it, or say why with <<replaces = \""
                                    + entry.name()
                                    + ": reason\">> on a component"));
            return;
        }
        Diagnostic finding =
                Diagnostic.error(NOT_KEPT, entry.fresh().orElseThrow(), message(entry));
        for (Sentence sentence : entry.change().witnesses().get(0).verdict().explanation()) {
            if (sentence.place().isPresent()) {
                finding = finding.withRelated(sentence.place().get(), sentence.text());
            }
        }
        findings.add(finding);
    }

    private String message(Gate.Entry entry) {
        if (entry.cause().isPresent()) {
            return "'%s' does not keep what it promised because of its part '%s', which changed"
                    .formatted(entry.name(), entry.cause().get());
        }
        boolean widens = entry.change().relation() == Change.Relation.WIDENS;
        return "'"
                + entry.name()
                + "' does not keep what it promised"
                + (widens ? ": it promises less; " : "; ")
                + "let it refine the base again, or say why not with <<breaks = \"reason\">>"
                + afterSpent(entry);
    }

    private String afterSpent(Gate.Entry entry) {
        String name = entry.name().replaceFirst("<.*", "");
        return excuses.hasSpent(name, fresh.components().get(name))
                ? "; the reason that it has is in the base, too: it was given for an earlier"
                        + " change"
                : "";
    }

    private void unknown(Gate.Entry entry) {
        findings.add(
                Diagnostic.warning(
                        UNKNOWN,
                        entry.fresh().orElseThrow(),
                        "whether '"
                                + entry.name()
                                + "' keeps what it promised is unknown: "
                                + entry.change().reason()));
    }

    /** Where another break asks for a new reason, that has been said. */
    private void unneeded(Map.Entry<String, GateSide.Declared> component) {
        boolean fails =
                findings.stream().anyMatch(each -> each.span().equals(component.getValue().name()));
        for (Excuses.Unneeded each : excuses.unneeded(component.getKey(), component.getValue())) {
            if (fails && each.spent()) {
                continue;
            }
            findings.add(
                    Diagnostic.warning(
                            UNNEEDED_REASON,
                            each.stereotype().span(),
                            "nothing needs this reason"
                                    + (each.spent()
                                            ? ": the base has it, too, so it was given for an"
                                                    + " earlier change"
                                            : "")
                                    + "; delete '"
                                    + each.stereotype().name()
                                    + "'"));
        }
    }
}
