package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.BehaviourReader.Reading;
import arcomat.tree.Behaviour;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The behaviours in other languages than automata: what mends Arcomat's own text may spoil theirs,
 * and they may have codes of their own for what laws find.
 */
record ForeignText(List<Body> bodies) {
    private static final Reading UNKNOWN = Reading.of(List.of());

    /**
     * The text of a behaviour.
     *
     * @param reading what came of it; nothing is known of what was read without looking around
     */
    private record Body(Span text, Reading reading) {}

    /** In the files that something was found in. */
    static ForeignText around(Collection<Diagnostic> findings, Workspace workspace) {
        Set<String> files =
                findings.stream()
                        .map(each -> each.span().file().path())
                        .collect(Collectors.toSet());
        List<Body> bodies = new ArrayList<>();
        for (ComponentSymbol component : workspace.meantComponents()) {
            if (files.contains(component.unit().file().path())) {
                for (Behaviour.Foreign each : component.node().elements(Behaviour.Foreign.class)) {
                    Reading reading = component.readings().getOrDefault(each, UNKNOWN);
                    bodies.add(new Body(each.body(), reading));
                }
            }
        }
        return new ForeignText(bodies);
    }

    /** The finding as the language tells it that it is about. */
    Diagnostic told(Diagnostic finding) {
        return bodies.stream()
                .filter(body -> body.text().isAround(finding.span()))
                .findFirst()
                .map(body -> told(finding, body.reading()))
                .orElse(finding);
    }

    private static Diagnostic told(Diagnostic finding, Reading reading) {
        boolean isItsOwn =
                reading.problems().stream()
                        .anyMatch(
                                each ->
                                        each.code().equals(finding.code())
                                                && each.place().equals(finding.span()));
        if (isItsOwn) {
            return finding;
        }
        Optional<Fix> safe = finding.fix().filter(fix -> isTakenOver(fix, reading));
        return new Diagnostic(
                reading.codes().getOrDefault(finding.code(), finding.code()),
                finding.severity(),
                finding.span(),
                finding.message(),
                finding.related(),
                safe);
    }

    /** Whether all that it edits is Arcomat's own text, letter by letter. */
    private static boolean isTakenOver(Fix fix, Reading reading) {
        return fix.edits().stream()
                .allMatch(
                        edit ->
                                reading.takenOver().stream()
                                        .anyMatch(place -> place.isAround(edit.span())));
    }
}
