package arcomat.pipeline.gate;

import arcomat.analysis.evolution.Change;
import arcomat.analysis.evolution.Gate;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** What the gate found, with the places in both models. */
final class GateFindings {
    private static final String NOT_KEPT = "ARC1101";
    private static final String GONE = "ARC1102";
    private static final String UNNEEDED_REASON = "ARC1103";
    private static final String UNKNOWN = "ARC1104";

    private final GateSide fresh;
    private final BreakReasons reasons;
    private final List<Diagnostic> findings = new ArrayList<>();
    private final List<Suppressed> meant = new ArrayList<>();

    private GateFindings(GateSide fresh, BreakReasons reasons) {
        this.fresh = fresh;
        this.reasons = reasons;
    }

    /** What files that are left out make of it is not told: they have findings of their own. */
    static GateFindings of(Gate gate, GateSide base, GateSide fresh, BreakReasons reasons) {
        GateFindings all = new GateFindings(fresh, reasons);
        gate.entries().stream()
                .filter(entry -> entry.change().relation().isDoubtful())
                .filter(entry -> entry.change().relation() != Change.Relation.UNREAD)
                .forEach(all::add);
        if (base.isWhole() && fresh.isWhole()) {
            all.unneeded();
        }
        all.findings.sort(Diagnostic.ORDER);
        all.meant.sort(Comparator.comparing(Suppressed::finding, Diagnostic.ORDER));
        return all;
    }

    /** Reasons that nothing asked for. */
    private void unneeded() {
        fresh.components().entrySet().stream()
                .filter(each -> fresh.isNamedByUser(each.getValue()))
                .forEach(this::unneeded);
    }

    /** What nobody gives a reason for. */
    List<Diagnostic> findings() {
        return findings;
    }

    /** What the models give a reason for. */
    List<Suppressed> meant() {
        return meant;
    }

    private void add(Gate.Entry entry) {
        Diagnostic finding = finding(entry);
        entry.excuse()
                .ifPresentOrElse(
                        reason -> meant.add(new Suppressed(finding, reason)),
                        () -> findings.add(finding));
    }

    private Diagnostic finding(Gate.Entry entry) {
        return switch (entry.change().relation()) {
            case GONE -> gone(entry);
            case UNKNOWN -> unknown(entry);
            default -> notKept(entry);
        };
    }

    private static Diagnostic gone(Gate.Entry entry) {
        return Diagnostic.error(
                GONE,
                entry.old().orElseThrow(),
                "'"
                        + entry.name()
                        + "' is gone; keep it, or say why with <<replaces = \""
                        + entry.name()
                        + ": reason\">> on a component");
    }

    private Diagnostic notKept(Gate.Entry entry) {
        Diagnostic finding =
                Diagnostic.error(NOT_KEPT, entry.fresh().orElseThrow(), message(entry));
        for (Sentence sentence : entry.change().witnesses().get(0).verdict().explanation()) {
            if (sentence.place().isPresent()) {
                finding = finding.withRelated(sentence.place().get(), sentence.text());
            }
        }
        return finding;
    }

    private static Diagnostic unknown(Gate.Entry entry) {
        return Diagnostic.warning(
                UNKNOWN,
                entry.fresh().orElseThrow(),
                "whether '%s' keeps what it promised is unknown: %s"
                        .formatted(entry.name(), entry.change().reason()));
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
        return reasons.hasSpent(name, Objects.requireNonNull(fresh.components().get(name)))
                ? "; the reason that it has is in the base, too: it was given for an earlier"
                        + " change"
                : "";
    }

    /** Where another break asks for a new reason, that has been said. */
    private void unneeded(Map.Entry<String, GateSide.Declared> component) {
        boolean fails =
                findings.stream().anyMatch(each -> each.span().equals(component.getValue().name()));
        for (BreakReasons.Unneeded each :
                reasons.unneeded(component.getKey(), component.getValue())) {
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
