package arcomat.check;

import arcomat.symbols.ComponentSymbol;

/** ARC0401: the component behind {@code refines} exists and is unambiguous. */
final class RefinesExists implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0401");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ComponentSymbol.Refinement refinement : component.refines()) {
            ComponentNames.check(refinement.node(), refinement.resolution(), context, findings);
        }
    }
}
