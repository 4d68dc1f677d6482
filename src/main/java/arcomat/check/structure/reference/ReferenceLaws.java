package arcomat.check.structure.reference;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class ReferenceLaws {
    public static final List<Law> LAWS =
            List.of(
                    warning("ARC0149", new ArrayIsList()).needing(NAMES),
                    error("ARC0111", new ComponentExists()).needing(NAMES),
                    error("ARC0121", new ImportResolves()),
                    warning("ARC0122", new ImportUnique()),
                    warning("ARC0123", new ImportUsed()).needing(ALL),
                    warning("ARC0147", new JavaTypeImported()).needing(NAMES),
                    error("ARC0115", new TypeArgumentsComplete()),
                    error("ARC0116", new TypeArgumentsInBounds()),
                    error("ARC0120", new TypeExists()).needing(NAMES));

    private ReferenceLaws() {}
}
