package arcomat.check.facts;

import arcomat.check.law.Check.Context;
import arcomat.check.law.Check.Findings;
import arcomat.source.Fix;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.Outline;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.QualifiedName;

import java.util.List;
import java.util.Optional;

/** Findings about names of components that do not lead to one component. */
public final class UnresolvedComponents {
    private UnresolvedComponents() {}

    public static void check(
            QualifiedName name,
            Resolution<Signature> resolution,
            Context context,
            Findings findings) {
        if (resolution.isUnknown()) {
            reportUnknown(name, context, findings);
        } else if (resolution.isAmbiguous()) {
            reportAmbiguous(name, resolution.candidates(), findings);
        }
    }

    private static void reportUnknown(QualifiedName name, Context context, Findings findings) {
        String message = "there is no component '" + name + "'";
        Optional<String> elsewhere = elsewhere(name, context);
        if (elsewhere.isPresent()) {
            String found = elsewhere.get();
            findings.report(name, "%s here, but there is '%s'; write that name", message, found)
                    .fix(Fix.replace("Write '" + found + "'", name.span(), found));
            return;
        }
        findings.reportUnknown(
                name.span(),
                message,
                name.text(),
                candidates(name, context),
                "correct the name, or add the file to those that are read");
    }

    /** The one component of that name in another package, if it was named without its package. */
    private static Optional<String> elsewhere(QualifiedName name, Context context) {
        List<String> found =
                context.workspace().outlines().stream()
                        .flatMap(file -> file.components().stream())
                        .filter(c -> name.isSimple() && Outline.simple(c).equals(name.text()))
                        .toList();
        return found.size() == 1 ? Optional.of(found.get(0)) : Optional.empty();
    }

    /** Qualified names for a qualified one; else the simple names of the same package. */
    private static List<String> candidates(QualifiedName name, Context context) {
        String here = context.unit().packageText();
        Optional<String> self = context.component().map(ComponentSymbol::qualifiedName);
        return context.workspace().outlines().stream()
                .filter(file -> !name.isSimple() || file.packageName().equals(here))
                .flatMap(file -> file.components().stream())
                .filter(c -> !self.equals(Optional.of(c)))
                .map(c -> name.isSimple() ? Outline.simple(c) : c)
                .distinct()
                .toList();
    }

    private static void reportAmbiguous(
            QualifiedName name, List<Signature> candidates, Findings findings) {
        List<String> names = candidates.stream().map(Signature::qualifiedName).distinct().toList();
        if (names.size() == 1) {
            return; // A component that is there twice is told where it is declared.
        }
        findings.report(
                name,
                "'%s' could be %s; write its package or import one of them",
                name,
                Wording.quoted(names));
        for (Signature candidate : candidates) {
            findings.related(candidate.nameSpan(), "could be meant");
        }
    }
}
