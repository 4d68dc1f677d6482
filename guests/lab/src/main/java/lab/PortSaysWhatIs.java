package lab;

import arcomat.check.law.Check;
import arcomat.symbols.expressions.PortSymbol;

/** LAB0001: a port says what is, not what is not. */
final class PortSaysWhatIs implements Check.OnPort {
    @Override
    public void check(PortSymbol port, Context context, Findings findings) {
        if (port.name().matches("(not|no|un)\\p{Lu}.*")) {
            findings.report(
                    port.nameSpan(), "port '%s' says what is not; say what is", port.name());
        }
    }
}
