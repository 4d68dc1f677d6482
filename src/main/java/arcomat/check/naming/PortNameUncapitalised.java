package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.symbols.expressions.PortSymbol;

/** ARC0210: names of ports start with a small letter, unlike those of types. (Hab16 CV2) */
public final class PortNameUncapitalised implements Check.OnPort {

    @Override
    public void check(PortSymbol port, Context context, Findings findings) {
        boolean capital = Character.isUpperCase(port.name().charAt(0));
        if (capital && !port.implicit()) {
            findings.report(
                    port.nameSpan(),
                    "port '%s' should start with a small letter; rename it",
                    port.name());
        }
    }
}
