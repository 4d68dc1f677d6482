package arcomat.check.diagrams;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;
import static arcomat.check.law.Law.warningThenError;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class DiagramLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0603", new AttributesUnique()),
                    error("ARC0607", new ClassContainsItself()),
                    error("ARC0604", new ClassInheritanceAcyclic()),
                    warning("ARC0609", new DiagramDefinesTypes()),
                    error("ARC0601", new DiagramTypesUnique()),
                    error("ARC0602", new EnumConstantsUnique()),
                    warningThenError("ARC0608", new EnumFitsClass()),
                    error("ARC0605", new EnumNotEmpty()).needing(ALL),
                    error("ARC0606", new SuperClassIsClass()));

    private DiagramLaws() {}
}
