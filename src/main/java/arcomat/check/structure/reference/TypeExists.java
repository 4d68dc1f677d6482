package arcomat.check.structure.reference;

import arcomat.check.facts.MeantParts;
import arcomat.check.facts.VisibleNames;
import arcomat.check.law.Check;
import arcomat.check.naming.JavaClassUnique;
import arcomat.source.Fix;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnsupportedType;
import arcomat.tree.TypeReference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** ARC0120: a type is one that messages can have, and it is clear which one is meant. */
public final class TypeExists implements Check.OnType {
    /** With one of their letters wrong, {@code timing instant;} declares a variable. */
    private static final List<String> CLAUSES =
            List.of("timing", "behavior", "autoconnect", "autoinstantiate");

    @Override
    public void check(TypeReference type, Context context, Findings findings) {
        Resolution<TypeSymbol> resolution = context.resolve(type);
        if (resolution.isUnknown() && !isMeantAsPart(type, context)) {
            reportUnknown(type, context, findings);
        } else if (resolution.isAmbiguous() && !areDuplicates(resolution.candidates())) {
            findings.report(
                    type.name(),
                    "'%s' could mean several types; write the full name of one",
                    type.name());
            for (TypeSymbol candidate : resolution.candidates()) {
                if (candidate instanceof DefinedType defined) {
                    findings.related(defined.nameSpan(), defined.qualifiedName());
                }
            }
        } else if (type.range().isEmpty()
                && resolution.found().orElse(null) instanceof UnsupportedType unsupported) {
            findings.report(
                    type, "'%s' is no message type; %s", unsupported.text(), unsupported.advice());
        }
    }

    /** The business of ARC0142. */
    private static boolean isMeantAsPart(TypeReference type, Context context) {
        return context.component().isPresent()
                && MeantParts.in(context.component().get()).stream()
                        .anyMatch(each -> each.type() == type);
    }

    /** Definitions of one full name are the business of {@link JavaClassUnique}. */
    private static boolean areDuplicates(List<TypeSymbol> candidates) {
        return candidates.stream().map(TypeExists::fullName).distinct().count() == 1;
    }

    private static String fullName(TypeSymbol type) {
        return type instanceof DefinedType defined ? defined.qualifiedName() : type.text();
    }

    private static void reportUnknown(TypeReference type, Context context, Findings findings) {
        List<String> elsewhere = VisibleNames.typesElsewhere(type.name(), context);
        if (elsewhere.size() == 1) {
            Imports.reportMissing(type.name(), "type", elsewhere.get(0), context.unit(), findings);
            return;
        }
        Optional<BuiltinType> meant = BuiltinType.meantBy(type.name().text());
        if (meant.isPresent()) {
            reportMeant(type, meant.get(), findings);
            return;
        }
        List<String> names = new ArrayList<>(VisibleNames.types(context));
        if (type.span().equals(type.name().span())) {
            names.addAll(CLAUSES);
        }
        findings.reportUnknown(
                type.name().span(),
                "there is no type '" + type.name() + "'",
                type.name().text(),
                names,
                advice(type, context));
    }

    private static void reportMeant(TypeReference type, BuiltinType meant, Findings findings) {
        findings.report(
                        type.name(),
                        "there is no type '%s'; did you mean '%s'?",
                        type.name(),
                        meant.text())
                .fix(
                        Fix.replace(
                                "Replace '%s' by '%s'".formatted(type.name(), meant.text()),
                                type.name().span(),
                                meant.text()));
    }

    private static String advice(TypeReference type, Context context) {
        return context.scope().component(type.name()).isFound()
                ? "a component is no type of messages"
                : "define it in a class diagram, or import it";
    }
}
