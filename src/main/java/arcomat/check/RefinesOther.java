package arcomat.check;

import arcomat.symbols.ComponentSymbol;

/** ARC0403: a component refines another one, not itself. */
final class RefinesOther implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0403");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ComponentSymbol.Refinement refinement : component.refines()) {
            if (refinement.resolution().found().filter(component::equals).isPresent()) {
                findings.report(
                        refinement.node(),
                        "component '"
                                + component.name()
                                + "' refines itself; name the other version with its package");
            }
        }
    }
}
