package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Behaviour;

import java.util.ArrayList;
import java.util.List;

/** The behaviours in languages of guests: what mends Arcomat's own text may spoil theirs. */
record ForeignText(List<Span> bodies) {
    static ForeignText in(Workspace workspace) {
        List<Span> bodies = new ArrayList<>();
        for (ComponentSymbol component : workspace.components()) {
            for (Behaviour.Foreign each : component.node().elements(Behaviour.Foreign.class)) {
                bodies.add(each.body());
            }
        }
        return new ForeignText(bodies);
    }

    /** The finding, which proposes nothing that would be written into such a behaviour. */
    Diagnostic withoutRepair(Diagnostic finding) {
        boolean isInside =
                finding.fix().isPresent()
                        && bodies.stream().anyMatch(body -> body.isAround(finding.span()));
        return isInside ? finding.withoutFix() : finding;
    }
}
