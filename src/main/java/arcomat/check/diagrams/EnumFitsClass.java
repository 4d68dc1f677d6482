package arcomat.check.diagrams;

import arcomat.check.law.Check;
import arcomat.tree.ClassDiagram;

/** ARC0608: an enum is small enough to become a Java class. */
public final class EnumFitsClass implements Check.OnEnum {

    /** A class is set up by one method of 64 kB, and a constant takes 24 bytes of it. */
    private static final int MOST = 2_700;

    @Override
    public void check(ClassDiagram.EnumDefinition definition, Context context, Findings findings) {
        int constants = definition.constants().size();
        if (constants > MOST) {
            findings.report(
                    definition.name(),
                    "enum '%s' has %s constants, and a Java class has room for %s, so no code can"
                            + " be generated; use a range of numbers, such as Integer[1..%s]",
                    definition.name(),
                    constants,
                    MOST,
                    constants);
        }
    }
}
