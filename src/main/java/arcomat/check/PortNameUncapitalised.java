package arcomat.check;

import arcomat.tree.Element;
import arcomat.tree.Name;

/** ARC0210: names of ports start with a small letter, unlike those of types. (Hab16 CV2) */
final class PortNameUncapitalised implements Check.OnPort {

    @Override
    public Law law() {
        return Law.warning("ARC0210");
    }

    @Override
    public void check(Element.Port port, Context context, Findings findings) {
        for (Name name : port.names()) {
            if (Character.isUpperCase(name.text().charAt(0))) {
                findings.report(
                        name, "port '" + name + "' should start with a small letter; rename it");
            }
        }
    }
}
