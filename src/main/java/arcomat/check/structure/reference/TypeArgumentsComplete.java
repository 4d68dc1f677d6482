package arcomat.check.structure.reference;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.TypeReference.TypeArgument;

/** ARC0115: a generic component gets one type for each of its type parameters. (Hab16 R9) */
public final class TypeArgumentsComplete implements Check.OnComponentUse {

    @Override
    public void check(ComponentUse use, Context context, Findings findings) {
        use.reference().component().ifPresent(generic -> check(use, generic, findings));
    }

    private static void check(ComponentUse use, Signature generic, Findings findings) {
        int expected = generic.typeParameters().size();
        if (use.arguments().size() != expected) {
            findings.report(use.name(), message(use.reference(), expected, use.arguments().size()))
                    .related(generic.nameSpan(), "declared here");
            return;
        }
        for (TypeArgument argument : use.arguments()) {
            if (argument instanceof TypeArgument.Wildcard) {
                findings.report(
                        argument,
                        "a wildcard is no type; write the type of the messages of '%s'",
                        use.reference().name());
            }
        }
    }

    private static String message(ComponentReference reference, int expected, int given) {
        return expected == 0
                ? "component '%s' takes no type arguments; delete them".formatted(reference.name())
                : "component '%s' takes %s, but gets %s; write one type for each type parameter"
                        .formatted(
                                reference.name(), Wording.count(expected, "type argument"), given);
    }
}
